#pragma once

#include <opencv2/core.hpp>

namespace boomwatch {

/// A calibrated pair of cameras. Pixels for the intrinsics, metres for the baseline.
///
/// Unrectified: M, D, R, T as OpenCV's stereo calibration gives them (right = R left + T).
/// Rectified: `rectified` is true, D is empty, R the identity, T = (-baseline, 0, 0) and the
/// principal points may differ in x (Middlebury's doffs).
struct StereoRig {
  cv::Size imageSize;  ///< of the calibrated images; empty when the file does not say (KITTI)
  cv::Matx33d leftMatrix, rightMatrix;        ///< M1, M2
  cv::Mat leftDistortion, rightDistortion;    ///< D1, D2, CV_64F, empty if none
  cv::Matx33d rotation = cv::Matx33d::eye();  ///< R
  cv::Vec3d translation;                      ///< T, metres
  bool rectified = false;

  /// Metres.
  double baseline() const { return cv::norm(translation); }
};

}  // namespace boomwatch
