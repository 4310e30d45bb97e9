#pragma once

#include <memory>
#include <string>

#include "sources/frame_source.h"

namespace boomwatch {

/// Opens a recorded stereo pair: `path` as findStereoFiles takes it. `address` is what info() says.
///
/// The calibration is options.calibration, or the one that lies in the folder or above it. Stamps
/// are from timestamps.txt or times.txt in the folder (seconds, a line a pair), from names that are
/// nanoseconds, or else even at the video's rate or 10 a second.
/// A picture that cannot be read or has another size gives Bad. Throws Error when the recording or
/// its calibration cannot be used.
std::unique_ptr<FrameSource> openStereoSource(const std::string& path, const std::string& address,
                                              const SourceOptions& options);

}  // namespace boomwatch
