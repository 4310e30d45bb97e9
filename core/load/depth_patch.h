#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "frame/cloud.h"

namespace boomwatch {

/// The cloud around the tool as the camera sees it: a grid of directions u = x/z, v = y/z, and in
/// each cell the median inverse depth q = 1/z of its points.
///
/// Inverse depth, because stereo's noise is the same everywhere in it (dz = z^2 k, so dq = k) and
/// planes and lines stay planes and lines: weighting by 1/z^4 comes by itself. u and v have no
/// noise to speak of, so the outline of a thing is known far better than its depth.
struct DepthPatch {
  /// One point of the cloud.
  struct Sample {
    float u, v, q;
  };
  int side = 0;       ///< cells along u and along v
  double cell = 0.0;  ///< width of a cell in u and v
  double u0 = 0.0;    ///< where the grid begins
  double v0 = 0.0;
  double noise = 0.0;  ///< k: standard deviation of one point's q, 1/m
  double pitch = 0.0;  ///< spacing of the samples in u and v
  double uMin = 0.0, uMax = 0.0, vMin = 0.0, vMax = 0.0;  ///< what the whole cloud spans

  std::vector<Sample> samples;     ///< in the order of the cells
  std::vector<std::size_t> begin;  ///< cell i has samples [begin[i], begin[i + 1])
  std::vector<float> q;            ///< a cell's median; NaN where nothing was measured
  std::vector<float> sigma;        ///< a cell's standard deviation of q, from the noise

  bool empty() const { return samples.empty(); }
  /// Camera frame, metres; the cell must have been measured.
  Eigen::Vector3d point(int index) const {
    const double z = 1.0 / q[static_cast<std::size_t>(index)];
    return {(u0 + (index % side + 0.5) * cell) * z, (v0 + (index / side + 0.5) * cell) * z, z};
  }
  /// The cell of a direction; -1 outside.
  int indexOf(double u, double v) const {
    const double column = std::floor((u - u0) / cell), row = std::floor((v - v0) / cell);
    if (!(column >= 0 && column < side && row >= 0 && row < side)) return -1;
    return static_cast<int>(row) * side + static_cast<int>(column);
  }
};

/// All that lies up to `reach` metres beside the tool, at the tool's depth, in cells of reach / 75;
/// coarser where the points are sparse. Of a dense cloud so many points are left out that a cell
/// has `samplesPerCell` or up to twice as many. `noise` as in DepthPatch. Empty where nothing was
/// measured there or the tool point is not in front of the camera. Pure.
DepthPatch patchAround(const Cloud& cloud, const Eigen::Vector3f& tool, double reach, double noise,
                       double samplesPerCell);

}  // namespace boomwatch
