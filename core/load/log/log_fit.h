#pragma once

#include <optional>

#include "load/load_body.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// The log that is held at the tool. `body` must have no fault.
///
/// With locked sizes, or with those of `known` (a log's box, its axis as x), a log is found as well
/// that is seen from one end only: it lies where that end is. Refused where that is not so.
/// Deterministic; pure.
LoadDetection findLog(const DepthPatch& patch, const LoadBody& body,
                      const LoadParameters& parameters, const std::optional<OrientedBox>& known);

/// The same log a moment later: `expected` (its axis as x) is where it is by now, about; its tilt
/// towards the camera may be off by some 12 degrees. Needs to see far less than findLog(). Refused
/// when what is seen there is not that log. Pure.
LoadDetection followLog(const DepthPatch& patch, const Eigen::Vector3d& tool,
                        const LoadParameters& parameters, const OrientedBox& expected);

/// Whether a box is that of a log, its axis as x.
bool isLog(const OrientedBox& box);

}  // namespace boomwatch
