#pragma once

#include <filesystem>
#include <vector>

#include "sources/depth_calibration.h"

namespace boomwatch {

/// The files of one frame.
struct DepthFrameFiles {
  std::filesystem::path depth;
  std::filesystem::path colour;      ///< empty: none
  std::filesystem::path intrinsics;  ///< of this frame alone; empty: the recording's
  double stamp = 0.0;                ///< seconds
};

/// What a folder of depth images holds.
struct DepthRecording {
  DepthCalibration calibration;  ///< unused for frames with intrinsics of their own
  std::vector<DepthFrameFiles> frames;
  double rate = 0.0;  ///< frames a second, roughly
};

/// Finds out which of the layouts named at openDepthSource a folder has, and lists it. Throws
/// Error.
DepthRecording findDepthRecording(const std::filesystem::path& folder);

}  // namespace boomwatch
