#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "load/depth_patch.h"
#include "load/load_tuning.h"

namespace boomwatch {

/// q = n . (u, v, 1): a plane that does not go through the camera, 1/|n| metres away.
struct DepthPlane {
  Eigen::Vector3d n;

  /// Whether a cell is within `thickness` metres of it, or within LoadTuning::deviations.
  bool holds(const DepthPatch& patch, int cell, double thickness) const {
    const auto i = static_cast<std::size_t>(cell);
    const Eigen::Vector3d direction(patch.u0 + (cell % patch.side + 0.5) * patch.cell,
                                    patch.v0 + (cell / patch.side + 0.5) * patch.cell, 1.0);
    return std::abs(patch.q[i] - n.dot(direction)) <=
           thickness * n.norm() * patch.q[i] + LoadTuning::deviations * patch.sigma[i];
  }
};

/// The plane that holds most of `cells`, by RANSAC and least squares in q. Absent when no three of
/// them span one. `cells` must not be empty. Deterministic; pure.
std::optional<DepthPlane> dominantPlane(const DepthPatch& patch, const std::vector<int>& cells,
                                        double thickness);

}  // namespace boomwatch
