#pragma once

#include <filesystem>
#include <string>

#include "frame/stereo_rig.h"

namespace boomwatch {

/// Parses the text of OpenCV's stereo calibration (YAML, XML or JSON). `file` names it in errors
/// and finds its sibling (intrinsics.yml, extrinsics.yml). Throws Error for what it cannot read;
/// readCalibration checks whether the numbers make a usable pair of cameras.
StereoRig parseOpenCvCalibration(const std::filesystem::path& file, const std::string& text);

}  // namespace boomwatch
