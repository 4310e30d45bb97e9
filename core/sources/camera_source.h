#pragma once

#include <memory>
#include <string>

#include "sources/frame_source.h"

namespace boomwatch {

/// Opens live cameras: `devices` is LEFT,RIGHT, or ONE that gives both side by side (split in the
/// middle). Each is a device number, a path below /dev or a stream's address (rtsp://, udp://,
/// ...).
///
/// Left and right are paired by when they arrived; shots that are too far apart are not paired.
/// The stamp is the left shot's arrival, seconds since opening. next() never blocks longer than
/// its patience; opening and closing take a few seconds at most when a stream is silent.
/// Throws Error when a camera cannot be opened, or there is no calibration for it.
std::unique_ptr<FrameSource> openCameraSource(const std::string& devices,
                                              const std::string& address,
                                              const SourceOptions& options);

}  // namespace boomwatch
