#pragma once

#include <memory>

#include "sources/frame_source.h"

namespace boomwatch {

/// A recording of a single frame, shown as a still scene: the frame is delivered 20 times at 10 Hz,
/// each marked `still`, because a thing must be seen in several frames to enter the model
/// (Eq. 22-23). Any other source is returned as it is.
std::unique_ptr<FrameSource> repeatIfStill(std::unique_ptr<FrameSource> source);

}  // namespace boomwatch
