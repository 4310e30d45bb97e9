#pragma once

#include <filesystem>
#include <string>

#include "stereo/calibration.h"

namespace boomwatch {

/// Parse the text of KITTI's and of Middlebury's calib.txt. `file` names it in errors. They throw
/// Error for what they cannot read; readCalibration checks whether the numbers make a usable pair.
StereoRig parseKittiCalibration(const std::filesystem::path& file, const std::string& text,
                                CameraPair pair);
StereoRig parseMiddleburyCalibration(const std::filesystem::path& file, const std::string& text);

}  // namespace boomwatch
