#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

#include "frame/cloud.h"

namespace boomwatch {

/// How a depth image and points belong together.
struct DepthCalibration {
  PinholeCamera camera;           ///< width and height stay 0: the image gives them
  double unitsPerMetre = 1000.0;  ///< of the values of the depth image
};

/// Reads intrinsics from OpenCV's YAML, XML or JSON: a 3 x 3 matrix `camera_matrix`, `M1`,
/// `intrinsic` or `K`, or numbers `fx fy cx cy`; optionally `depth_factor`, the depth image's units
/// a metre (1000 if absent). Throws Error naming the file and what is wrong.
DepthCalibration readDepthCalibration(const std::filesystem::path& file);

/// The organised cloud of a depth image (CV_16UC1; 0 is unmeasured), with its camera:
/// X = (u - cx) z / fx, Y = (v - cy) z / fy. Pure.
Cloud cloudFromDepth(const cv::Mat& depth, const DepthCalibration& calibration);

}  // namespace boomwatch
