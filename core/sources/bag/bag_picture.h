#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "sources/bag/bag_file.h"

namespace boomwatch {

/// A picture out of a bag, or why there is none.
struct BagPicture {
  std::int64_t stamp = 0;  ///< nanoseconds, when it was taken; 0 where the message does not say
  /// CV_8UC1 or CV_8UC3 (BGR), or depth: CV_16UC1, or CV_32FC1 in metres. Empty when there is none.
  cv::Mat image;
  std::string fault;  ///< English
};

/// Whether messages of this type hold pictures: ROS's Image and CompressedImage, foxglove's
/// RawImage and CompressedImage.
bool isPictureType(std::string_view type);

/// Decodes one message of such a topic: mono8, bgr8, rgb8, bgra8, rgba8, Bayer, yuv422, mono16,
/// 16UC1, 32FC1; PNG and JPEG; depth that ROS's compressed_depth_image_transport packed as PNG.
/// Never throws. Any thread.
BagPicture decodePicture(const BagTopic& topic, std::string_view bytes);

/// The stamp alone of any message that begins with a header, or of foxglove's; 0 without one.
std::int64_t stampIn(const BagTopic& topic, std::string_view bytes);

/// A depth picture with `unitsPerMetre` (of CV_16UC1; CV_32FC1 holds metres) in millimetres,
/// CV_16UC1, 0 is unmeasured; farther than 65 m is unmeasured.
cv::Mat depthInMillimetres(const cv::Mat& depth, double unitsPerMetre);

}  // namespace boomwatch
