#pragma once

#include <random>

#include "frame/cloud.h"

namespace boomwatch::bench {

/// A floor, forty boxes on it and noise, as 442,368 pixels see them: organised, all measured.
inline Cloud floorWithBoxes() {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0.0F, 0.01F);
  Cloud cloud{768, 576, {}};
  for (int v = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u) {
      const bool box = (u / 48) % 2 == 0 && (v / 57) % 2 == 0;
      const float z = 9.0F - 5.0F * static_cast<float>(v) / 576.0F - (box ? 0.5F : 0.0F);
      const Eigen::Vector3f ray((static_cast<float>(u) - 384) / 700,
                                (static_cast<float>(v) - 288) / 700, 1.0F);
      cloud.points.emplace_back((z + noise(random)) * ray);
    }
  }
  return cloud;
}

}  // namespace boomwatch::bench
