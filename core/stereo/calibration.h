#pragma once

#include <filesystem>
#include <optional>

#include "stereo/stereo_rig.h"

namespace boomwatch {

/// Reads a stereo calibration: OpenCV's YAML or XML (M1 D1 M2 D2 R T in one file, or
/// intrinsics.yml with extrinsics.yml beside it, as OpenCV's stereo_calib sample writes them),
/// KITTI's calib.txt (P0: and P1: or the first two lines), or Middlebury's and ETH3D's calib.txt
/// (cam0=, cam1=, doffs=, baseline= in millimetres).
/// Throws Error naming the file and the key: missing, zero focal length, swapped baseline, ...
StereoRig readCalibration(const std::filesystem::path& file);

/// The calibration that lies in `folder`, by its usual names; absent if there is none.
std::optional<std::filesystem::path> findCalibration(const std::filesystem::path& folder);

}  // namespace boomwatch
