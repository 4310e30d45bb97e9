#pragma once

#include "environment/environment_model.h"
#include "frame/clearance.h"
#include "frame/oriented_box.h"

namespace boomwatch {

/// The thesis's two-phase search (docs/method.md section 7, Eq. 12-21): cells behind the box, then
/// rays of `radius` cells every `interval` cells along its sides and one from each corner. Misses
/// what lies between the rays; kept for comparison, and drawn as in Fig. 14. Pure.
///
/// "Bounding volume can be represented using just four corner points" is read like this. Of the
/// box's three axes, the one that leans most towards z is its depth; the other two span the
/// rectangle halfway along it, and m_1..m_4 are that rectangle's corners, each with its own depth.
/// Its sides lie on the box's surface, and on them the rays begin. Lengths are counted in the model
/// plane: a step is one cell wide, however the box is tilted. Where that rectangle's projection is
/// a parallelogram, directions are as the equations have them, along the neighbouring side.
///
/// Phase 1 looks through each cell of the rectangle along z, from the solid box's front or back
/// face there; what lies between the faces is at distance 0. Distances are to the centre of a
/// cell's surface, and from a point of the box: never shorter than the exact clearance.
///
/// Measured, or NothingInRange when no ray meets anything; Unknown with NoLoad when the box is not
/// one (see isUsable). `rays` are the searched lines of phase 2, as far as they cross the grid.
/// `interval` below 1 counts as 1, `radius` below 0 as 0. Time and memory are bounded by the size
/// of the grid, whatever the box and the radius.
Clearance rayClearance(const EnvironmentModel& model, const OrientedBox& box, int interval,
                       int radius);

}  // namespace boomwatch
