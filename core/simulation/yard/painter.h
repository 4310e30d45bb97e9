#pragma once

#include <opencv2/core.hpp>

#include "simulation/pinhole_view.h"
#include "simulation/yard/ground.h"
#include "simulation/yard/part.h"

namespace boomwatch {

/// A camera that looks along z from `eye`. Camera frame, metres.
struct YardEye {
  PinholeCamera camera;
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Eigen::Matrix3d level;  ///< turns the camera frame into the yard frame, which is level
};

/// What such a camera sees: for every pixel the nearest surface.
struct YardPicture {
  cv::Mat colour;  ///< CV_8UC3 (BGR)
  cv::Mat depth;   ///< CV_32FC1, z in metres; infinite where there is the sky
  cv::Mat kind;    ///< CV_8UC1, a YardKind

  YardPicture clone() const { return {colour.clone(), depth.clone(), kind.clone()}; }
};

/// Sky and ground. Several threads; pure.
YardPicture paintGround(const YardEye& eye, const YardGround& ground);

/// Paints bodies (camera frame) over a picture wherever they are nearer than what it shows. A ray
/// is cast through each pixel that a body can cover, so depths are exact. Several threads.
void paint(const YardEye& eye, const Parts& parts, YardPicture& picture);

/// CV_8UC1: 255 wherever the bodies would be seen if nothing stood before them. Several threads.
cv::Mat silhouetteOf(const YardEye& eye, const Parts& parts);

}  // namespace boomwatch
