#pragma once

#include <string>

#include "frame/frame.h"

namespace boomwatch {

struct YardTruth;  // simulation/yard/yard_truth.h

/// A frame's load and truth as one line of JSON, without the line's end; what is not known is null.
///
/// frame, stamp (s), distance_m, load {centre, size, axes: x y z}; and of demo:yard also log
/// {centre, axis, length, radius}, tool {point, pixel, box: x y width height, visible}, nearest,
/// person, branch {kind, distance_m, on_load, on_thing}. Metres, camera frame; pixels of the left
/// picture. `frame.trueDistance` must be set; `yard` is null for the other demos.
std::string truthJson(const Frame& frame, const YardTruth* yard);

}  // namespace boomwatch
