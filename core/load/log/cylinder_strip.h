#pragma once

#include <optional>
#include <vector>

#include "load/log/viewed_cylinder.h"

namespace boomwatch {

/// The part of a cylinder that is seen along a line, without the tool, in the axes of a
/// CylinderFrame.
struct CylinderStrip {
  /// Where a slice across it ends before something that is farther away.
  struct Edge {
    double u, v;
    bool upper;
  };
  /// The mean of `count` samples that lie close together.
  struct Surface {
    double u, v, q;
    int count;
  };
  /// Metres.
  struct Limits {
    double halfWidth;  ///< how far from the line is looked
    double minRadius, maxRadius;
    AlongRange along;
  };
  std::vector<Surface> surface;
  std::vector<Edge> edges;
  ViewedCylinder guess;
  double outlined = 0.0;  ///< share of the slices with something on the line that fit its outline
};

/// Cuts what is seen around `line` into slices, follows each from the line outwards to where it
/// ends, and keeps those whose ends lie on two straight lines, as a cylinder's outline does: what
/// stands before it, and what it touches, are left away. `tool` in the frame's axes, metres. Absent
/// when no two lines hold enough. Deterministic; pure.
std::optional<CylinderStrip> cutStrip(const DepthPatch& patch, const CylinderFrame& frame,
                                      const NearLine& line, const Eigen::Vector3d& tool,
                                      const CylinderStrip::Limits& limits);

}  // namespace boomwatch
