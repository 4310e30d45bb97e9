#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

namespace boomwatch {

/// Pixels that one picture may have. Compressed files of a few kilobytes can claim a billion.
inline constexpr double largestImage = 64e6;

/// A picture, or why there is none.
struct ImageResult {
  cv::Mat image;      ///< CV_8UC1 or CV_8UC3 (BGR); empty when it could not be read
  std::string fault;  ///< "" when it could
};

/// Whether the name ends as one of the formats that readImage knows: PNG, JPEG, BMP, PGM, PPM.
bool hasImageExtension(const std::filesystem::path& file);

/// The size that the file's header claims; absent when there is none to be found.
std::optional<cv::Size> imageSize(const std::filesystem::path& file);

/// Reads a picture of any content without taking more memory than largestImage allows: the header
/// is looked at first. Orientation tags are ignored: a calibration belongs to pixels as stored.
/// Never throws. Any thread.
ImageResult readImage(const std::filesystem::path& file);

}  // namespace boomwatch
