#pragma once

#include "environment/environment_model.h"
#include "frame/clearance.h"
#include "frame/oriented_box.h"

namespace boomwatch {

/// The thesis's two-phase search (method.md section 7, Eq. 12-21): cells behind the box, then rays
/// of `radius` cells every `interval` cells along its sides and one from each corner. Misses what
/// lies between the rays; kept for comparison, and drawn as in Fig. 14. Pure.
///
/// Measured, or NothingInRange when no ray meets anything. `rays` are the searched lines.
Clearance rayClearance(const EnvironmentModel& model, const OrientedBox& box, int interval,
                       int radius);

}  // namespace boomwatch
