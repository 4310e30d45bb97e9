#pragma once

#include <filesystem>
#include <optional>

#include "frame/stereo_rig.h"

namespace boomwatch {

/// Which cameras of a rig that has several pairs (KITTI): P0 and P1, grey, or P2 and P3, colour.
enum class CameraPair { First, Second };

/// Reads a stereo calibration: OpenCV's YAML or XML (M1 D1 M2 D2 R T in one file, or
/// intrinsics.yml with extrinsics.yml beside it, as OpenCV's stereo_calib sample writes them),
/// KITTI's calib.txt (P0: and P1: or the first two lines), or Middlebury's and ETH3D's calib.txt
/// (cam0=, cam1=, doffs=, baseline= in millimetres).
/// OpenCV's files do not name the unit of T, which is that of the chessboard's squares: it must be
/// metres here. `image_width` with `image_height`, or `image_size`, may say the images' size.
/// Throws Error naming the file and the key: missing, zero focal length, swapped baseline, ...
StereoRig readCalibration(const std::filesystem::path& file, CameraPair pair = CameraPair::First);

/// Throws Error naming `where` and what no rig can have: a focal length of 0, a baseline in
/// millimetres or from right to left, a matrix that does not rotate, ...
void checkRig(const std::string& where, const StereoRig& rig);

/// The calibration that lies in `folder`, by its usual names; absent if there is none.
std::optional<std::filesystem::path> findCalibration(const std::filesystem::path& folder);

/// The text of a small calibration file. Throws Error when it is missing, a folder, empty, binary
/// or larger than any calibration.
std::string readCalibrationText(const std::filesystem::path& file);

}  // namespace boomwatch
