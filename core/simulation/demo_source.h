#pragma once

#include <memory>
#include <string>

#include "sources/frame_source.h"

namespace boomwatch {

/// `demo:floor`, `demo:cylinders`, `demo:wall`: the scenes of Fig. 11, 21 and 22 as a pinhole
/// camera of 768 x 576 pixels sees them, with a load that moves along x, y and z in turn. 600
/// frames, 20 a second, each with its load and true distance; the last leads on to the first.
///
/// As in the thesis's simulator the cloud holds the surroundings alone, and is one and the same for
/// all frames; the load appears in the picture only. Truth is the distance to the whole geometry,
/// seen or not (see distance in scene.h), within a micrometre.
///
/// `demo:yard` with its options: see YardSource.
///
/// Throws Error when there is no demo of that name.
std::unique_ptr<FrameSource> openDemoSource(const std::string& name, const std::string& address);

}  // namespace boomwatch
