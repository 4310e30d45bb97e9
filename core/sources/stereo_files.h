#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stereo/calibration.h"

namespace boomwatch {

/// What `stereo:PATH` names on disk: two lists of pictures that belong together by index, or two
/// video files.
struct StereoFiles {
  std::filesystem::path folder;  ///< where calibration and time stamps may lie
  std::vector<std::filesystem::path> left;
  std::vector<std::filesystem::path> right;  ///< as many as left
  bool video = false;                        ///< then one each
  CameraPair cameras = CameraPair::First;    ///< Second for KITTI's image_2 and image_3
};

/// Finds the pair. `path` is a folder that holds two folders of pictures (left/right, cam0/cam1,
/// image_0/image_1, ...), two videos, or pictures named in pairs (left01/right01, im0/im1, ...); or
/// it is LEFT,RIGHT, two folders or two files.
/// Throws Error when there is no pair, or left and right do not match one to one.
StereoFiles findStereoFiles(const std::string& path);

/// Whether findStereoFiles() recognises a left and a right in `folder`, by their names alone. It
/// may still refuse them. False for a folder that cannot be read.
bool holdsStereoPair(const std::filesystem::path& folder);

}  // namespace boomwatch
