#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "load/axis_search.h"
#include "load/viewed_cylinder.h"

namespace boomwatch {

/// What is seen along an axis, without the tool, in the axes of a CylinderFrame.
struct Strip {
  /// Where a slice across the strip stops.
  struct Edge {
    double u, v;
    bool upper;
  };
  /// How far from the axis, along it from its point, and from the tool point. Metres.
  struct Limits {
    double halfWidth;
    double halfLength = std::numeric_limits<double>::infinity();
    double toolRadius = 0.0;
  };
  /// The mean of `count` samples that lie close together.
  struct Surface {
    double u, v, q;
    int count;
  };
  std::vector<Surface> surface;
  std::vector<Edge> edges;
  ViewedCylinder guess;  ///< by robust lines through middles, depths and widths
};

/// Cuts the strip of samples at `body` around the axis into slices, and follows each from its
/// middle outwards to where the samples stop. Absent when there are too few. Pure.
std::optional<Strip> cutStrip(const DepthPatch& patch, const LoadBody& body,
                              const CylinderFrame& frame, const LoadAxis& axis,
                              const Strip::Limits& limits);

}  // namespace boomwatch
