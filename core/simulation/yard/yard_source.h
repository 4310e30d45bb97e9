#pragma once

#include <memory>
#include <string>

#include "sources/frame_source.h"

namespace boomwatch {

/// `demo:yard`, or `demo:yard,seed=7,rain=0.5,...` (see YardOptions): a simulated forestry yard
/// with uneven ground, trees, stacks of logs, a wall, somebody who walks about, birds and leaves,
/// and a crane that carries a log through it. 768 x 576 pixels, 20 frames a second, as the camera
/// on the machine's mast sees it; every frame with its load and its YardTruth.
///
/// The same options give the same bytes, and any frame can be had alone. `options` is what follows
/// "yard," in the address. Throws Error naming an option that is unknown or out of its range.
std::unique_ptr<FrameSource> openYardSource(const std::string& options, const std::string& address);

}  // namespace boomwatch
