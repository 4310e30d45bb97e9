#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>

#include "frame/cloud.h"
#include "simulation/demo_camera.h"
#include "simulation/scene.h"

namespace boomwatch {

/// What a camera sees of a scene that does not move.
struct SceneView {
  static constexpr double farthest = 30.0;  ///< metres in z beyond which nothing is measured

  std::shared_ptr<const Cloud> cloud;  ///< organised; the exact surface points, with the camera
  cv::Mat image;                       ///< CV_8UC1, shaded and textured
};

/// Casts a ray a pixel. Deterministic; pure.
SceneView lookAt(const Scene& scene, const PinholeCamera& camera = demoCamera);

/// The picture of `view` with a load in it, where nothing stands before it, and with the noise of a
/// sensor (at most 2 grey levels; another one for every `sequence`). Deterministic; pure.
cv::Mat pictureWithLoad(const SceneView& view, const OrientedBox& load, std::uint64_t sequence);

}  // namespace boomwatch
