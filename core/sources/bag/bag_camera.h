#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frame/pinhole_camera.h"
#include "frame/stereo_rig.h"
#include "sources/bag/bag_file.h"

namespace boomwatch {

/// What ROS's CameraInfo, or foxglove's CameraCalibration, says of a camera. Pixels; P's last
/// column in pixels times metres.
struct BagCamera {
  cv::Size size;
  std::string model;  ///< "plumb_bob", "rational_polynomial", ...; may be empty
  std::vector<double> distortion;
  cv::Matx33d matrix, rectification;  ///< K and R
  cv::Matx34d projection;             ///< P; all zero where the camera was never calibrated as one
                                      ///< of a pair (RealSense)
};

bool isCameraType(std::string_view type);

/// Absent when the message is damaged. Never throws.
std::optional<BagCamera> decodeCamera(const BagTopic& topic, std::string_view bytes);

/// The camera of pictures as they are; of the rectified ones by P where `rectified` and P is set.
PinholeCamera pinholeOf(const BagCamera& camera, bool rectified);

/// The rig of two cameras whose pictures are `rectified` (P alone holds) or are not (K, D, R, P).
/// Throws Error naming `where` when they do not make a pair, or their lens model is not known.
StereoRig rigOf(const std::string& where, const BagCamera& left, const BagCamera& right,
                bool rectified);

}  // namespace boomwatch
