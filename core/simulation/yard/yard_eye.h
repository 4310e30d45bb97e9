#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "simulation/demo_camera.h"
#include "simulation/yard/part.h"
#include "simulation/yard/yard_ground.h"

namespace boomwatch {

/// A camera that looks along z from `eye`. Camera frame, metres.
struct YardEye {
  PinholeCamera camera = demoCamera;
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Eigen::Matrix3d level = Eigen::Matrix3d::Identity();  ///< from the camera's to the yard frame

  cv::Size size() const { return {camera.width, camera.height}; }
};

constexpr std::int16_t nobody = -1;

/// The z at which the ray through each pixel meets the nearest body or triangle, where that is
/// nearer than what `depth` (CV_32FC1, the eye's size) holds. `owner` (CV_16SC1, or empty) gets the
/// body's index there. All in the camera frame. Exact; several threads.
void castParts(const YardEye& eye, const Parts& parts, cv::Mat& depth, cv::Mat& owner);
void castTriangles(const YardEye& eye, const std::vector<YardGround::Triangle>& triangles,
                   cv::Mat& depth);

/// CV_8UC1: 255 wherever the bodies would be seen if nothing stood before them. Several threads.
cv::Mat silhouetteOf(const YardEye& eye, const Parts& parts);

}  // namespace boomwatch
