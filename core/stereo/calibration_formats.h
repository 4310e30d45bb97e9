#pragma once

#include <filesystem>
#include <string>

#include "stereo/calibration.h"

namespace boomwatch {

/// The formats behind readCalibration. Each takes the file's text, and `file` to name it in errors
/// and to find its sibling. They throw Error for what they cannot read; whether the numbers make
/// a usable pair of cameras is readCalibration's to check.
StereoRig parseOpenCvCalibration(const std::filesystem::path& file, const std::string& text);
StereoRig parseKittiCalibration(const std::filesystem::path& file, const std::string& text,
                                CameraPair pair);
StereoRig parseMiddleburyCalibration(const std::filesystem::path& file, const std::string& text);

/// The text of a small file. Throws Error when it is missing, a folder, empty, binary or larger
/// than any calibration.
std::string readCalibrationText(const std::filesystem::path& file);

}  // namespace boomwatch
