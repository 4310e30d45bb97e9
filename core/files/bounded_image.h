#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string_view>

namespace boomwatch {

/// Pixels that one picture may have. Compressed files of a few kilobytes can claim a billion.
inline constexpr double maxImage = 64e6;

/// How a picture's pixels are wanted.
enum class PixelDepth {
  EightBit,  ///< CV_8UC1 or CV_8UC3 (BGR), whatever the file holds
  AsStored,  ///< depth and channels of the file: depth images have 16 bits
};

/// Whether the name ends as one of the formats that readImage knows: PNG, JPEG, BMP, PGM, PPM.
bool hasImageExtension(const std::filesystem::path& file);

/// The size, pixels, that the file's header claims; absent when there is none to be found, or it is
/// more than readImage reads. Never throws. Any thread.
std::optional<cv::Size> imageSize(const std::filesystem::path& file);

/// Reads a picture of any content without taking more memory than maxImage allows: the header
/// is looked at first. Orientation tags are ignored: a calibration belongs to pixels as stored.
/// Throws Error naming the file when it cannot be read. Any thread.
cv::Mat readImage(const std::filesystem::path& file, PixelDepth depth = PixelDepth::EightBit);

/// As readImage, of a picture in memory; empty when it cannot be read. Never throws. Any thread.
cv::Mat decodeImage(std::string_view bytes, PixelDepth depth = PixelDepth::EightBit);

}  // namespace boomwatch
