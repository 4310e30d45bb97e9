#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace boomwatch {

/// Where the target is, a frame an entry: pixels from the image's corner (0, 0); absent where it
/// cannot be seen.
using GroundTruth = std::vector<std::optional<cv::Rect2d>>;

/// The file in `folder` that says where the target is; absent when there is none.
std::optional<std::filesystem::path> groundTruthFile(const std::filesystem::path& folder);

/// Reads the truth beside a recording with pictures of `image` pixels. One line a frame, four
/// numbers parted by commas, tabs or blanks, pixels counted from 1 as these data sets do:
///
/// - groundtruth_rect.txt (OTB): x, y, width, height;
/// - gt.txt beside init.txt (TLD): first and last column and row, x1, y1, x2, y2;
/// - gt.txt alone: whichever of the two its numbers allow.
///
/// Four NaN, or a width and height of 0, say that the target cannot be seen. Throws Error naming
/// file and line when it cannot be read, or it cannot be told which of the two it is.
GroundTruth readGroundTruth(const std::filesystem::path& folder, cv::Size image);

}  // namespace boomwatch
