#pragma once

#include <opencv2/core.hpp>

#include "simulation/yard/lighting.h"

namespace boomwatch {

/// What a camera sees of the yard: for every pixel the nearest surface.
struct YardPicture {
  cv::Mat colour;  ///< CV_8UC3 (BGR)
  cv::Mat depth;   ///< CV_32FC1, z in metres; infinite where there is the sky
  cv::Mat kind;    ///< CV_8UC1, a YardKind
  cv::Mat sun;     ///< CV_8UC1, 255 times the share of the light there that comes from the sun

  YardPicture clone() const { return {colour.clone(), depth.clone(), kind.clone(), sun.clone()}; }
};

/// Sky and ground. Several threads; pure.
YardPicture paintGround(const YardEye& eye, const YardGround& ground, const YardShadows& shadows);

/// Paints bodies (camera frame) over a picture wherever they are nearer than what it shows. A ray
/// is cast through each pixel that a body can cover, so depths are exact. Several threads.
void paint(const YardEye& eye, const Parts& parts, const YardShadows& shadows,
           YardPicture& picture);

/// Lets further shadows fall on a picture, within `farthest` metres in z. Several threads.
void shade(const YardEye& eye, const YardShadows& shadows, double farthest, YardPicture& picture);

}  // namespace boomwatch
