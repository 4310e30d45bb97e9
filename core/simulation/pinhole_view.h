#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>

#include "frame/cloud.h"
#include "simulation/scene.h"

namespace boomwatch {

/// A camera at the origin of the camera frame, without distortion. Pixels; pixel (u, v) looks along
/// ((u - cx) / focal, (v - cy) / focal, 1).
struct PinholeCamera {
  int width = 768;
  int height = 576;
  double focal = 600.0;

  double cx() const { return (width - 1) / 2.0; }
  double cy() const { return (height - 1) / 2.0; }
  Eigen::Vector3d ray(int u, int v) const { return {(u - cx()) / focal, (v - cy()) / focal, 1.0}; }
};

/// What such a camera sees of a scene that does not move.
struct PinholeView {
  static constexpr double farthest = 30.0;  ///< metres in z beyond which nothing is measured

  PinholeCamera camera;
  std::shared_ptr<const Cloud> cloud;  ///< organised; the exact surface points
  cv::Mat image;                       ///< CV_8UC1, shaded and textured
};

/// Casts a ray a pixel. Deterministic; pure.
PinholeView lookAt(const Scene& scene, const PinholeCamera& camera = {});

/// The picture of `view` with a load in it, where nothing stands before it, and with the noise of a
/// sensor (at most 2 grey levels; another one for every `sequence`). Deterministic; pure.
cv::Mat pictureWithLoad(const PinholeView& view, const OrientedBox& load, std::uint64_t sequence);

}  // namespace boomwatch
