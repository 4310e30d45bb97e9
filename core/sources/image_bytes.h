#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace boomwatch {

/// Reads a PNG or a JPEG as it is stored (depth, number of channels). Throws Error naming the file
/// when it is neither, cannot be decoded, or claims more than 100 million pixels: that is looked up
/// in its header before anything is allocated.
cv::Mat readImageFile(const std::filesystem::path& file);

/// By its extension: .png, .jpg or .jpeg, in either case.
bool isImageFile(const std::filesystem::path& file);

}  // namespace boomwatch
