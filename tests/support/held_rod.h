#pragma once

#include "load/log/viewed_cylinder.h"
#include "support/ray_cast.h"

namespace boomwatch::ray_cast {

/// A rod's patch, frame and exact cylinder in that frame, as the stages of the log's detection get
/// them.
struct HeldRod {
  Rod rod;
  DepthPatch patch;
  CylinderFrame frame;
  Vector3d tool;  ///< in the frame's axes
  ViewedCylinder cylinder;

  HeldRod(const Rod& held, const Cloud& cloud)
      : rod(held),
        patch(patchAround(cloud, nearSide(held).cast<float>(), 1.8, noise, 4.0)),
        frame(*CylinderFrame::facing(nearSide(held), held.axis, 0.2)),
        tool(frame.toLocal(nearSide(held))) {
    const NearLine axis = NearLine::fromAxis(frame, {held.centre, held.axis});
    cylinder.ua = axis.ua, cylinder.ub = axis.ub;
    cylinder.x << axis.va, axis.vb, axis.qa, axis.qb, held.radius;
  }

  /// On its surface.
  LoadAxis start() const { return {nearSide(rod), rod.axis}; }
};

/// What the rod before a wall looks like where all beyond `u` is covered by something at 2 m.
inline Cloud halfCovered(const Rod& rod, double u) {
  return seen([&](double x, double y) { return x > u ? 2.0 : std::min(rod.depth(x, y), 8.0); });
}

}  // namespace boomwatch::ray_cast
