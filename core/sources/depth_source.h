#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "sources/frame_source.h"

namespace boomwatch {

/// `depth:PATH`: a folder of depth images (16-bit PNG, 0 is unmeasured) with their colour images,
/// in one of three layouts:
/// - TUM's: `depth.txt` and, if there is one, `rgb.txt` list stamps and files; a depth image goes
///   with the colour image nearest in time, at most 20 ms away, or with none. 5000 units a metre,
///   fx = fy = 525, cx = 319.5, cy = 239.5, unless an intrinsics file lies beside the lists.
/// - pairs in one folder: `NAME_depth.png`, `NAME.jpg` or `.png`, and intrinsics in
///   `NAME_camera.xml`, or in one intrinsics file for all.
/// - folders `depth/` and, if there is one, `colour/` (or `color/`, `rgb/`, `images/`), matched by
///   name, or in order where no name matches; with an intrinsics file.
/// The intrinsics file is `intrinsics`, `camera` or `calibration` with `.yaml`, `.yml`, `.xml` or
/// `.json`; see readDepthCalibration.
///
/// Throws Error when `path` holds none of these, or no intrinsics. An image that is unreadable, not
/// 16-bit depth, or of another size than its partner or the first frame gives a Bad frame.
std::unique_ptr<FrameSource> openDepthSource(const std::filesystem::path& path,
                                             const std::string& address);

}  // namespace boomwatch
