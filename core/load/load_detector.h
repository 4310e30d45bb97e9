#pragma once

#include "frame/bounds.h"
#include "frame/cloud.h"
#include "frame/viewed_box.h"
#include "load/load_detection.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// The carried load at the tool, from one cloud seen from one side (docs/method.md section 4).
///
/// `depthNoise`: standard deviation of a point's inverse depth, 1/m; of a stereo pair a quarter of
/// a pixel over f B (Eq. 5). Looks at `parameters`' shape, sizes (where they are locked), toolSize
/// and maxSize. A log's box has its axis as x, and z as far away from the camera as can be; of a
/// box that it cannot tell front from side, x is its longest edge. Refuses, with a reason, rather
/// than guess. Deterministic; pure; any cloud and any tool point.
///
/// `expected`: the load that was carried a moment ago, where it is by now, about (see
/// LoadFollower::expected). The same log is then found with an end or one whole side hidden.
LoadDetection detectLoad(const Cloud& cloud, const Eigen::Vector3f& tool, double depthNoise,
                         const Bounds& bounds, const LoadParameters& parameters,
                         const std::optional<OrientedBox>& expected = {});

/// In which points are taken for the load's: its box, `margin` metres larger on all sides, and
/// along the line of sight three standard deviations of the inverse depth more. `smear`, 1/m: by
/// how much farther away a matcher may put the rim of a near thing.
ViewedBox dynamicVolume(const OrientedBox& load, double margin, double depthNoise, double smear);

}  // namespace boomwatch
