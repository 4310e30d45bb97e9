#pragma once

#include <Eigen/Core>

#include "simulation/yard/part.h"

namespace boomwatch {

/// A place on a part, in its own frame (its box's axes, from its centre), metres.
struct SurfacePlace {
  Eigen::Vector3f at;
  Eigen::Vector3f normal;
  float footprint = 0.001F;  ///< metres that a pixel covers there
};

/// The colour (blue, green, red; 0..255) of a part's surface in full light. The pattern belongs to
/// the body and moves with it. Pure.
Eigen::Vector3f paintOf(const Part& part, const SurfacePlace& place);

/// The same for the ground; `place` is in the yard frame.
Eigen::Vector3f paintOfGround(const SurfacePlace& place);

/// Foliage has gaps: whether a ray goes through at this place. Pure.
bool isGap(const Part& part, const Eigen::Vector3f& at);

}  // namespace boomwatch
