#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "environment/environment_model.h"
#include "frame/clearance.h"
#include "frame/oriented_box.h"

namespace boomwatch {

/// The shortest distance from a box to the surface point of any occupied cell: the same answer as
/// looking at every cell, found by best-first branch and bound over a min/max pyramid of the depth
/// levels (docs/method.md section 7, Beyond).
///
/// rebuild() after every update of the model, then query() as often as wanted; query() is const and
/// may run on several threads at once. Keeps what it needs of the model: the model may go.
class ExactClearance {
 public:
  ExactClearance();
  ~ExactClearance();
  ExactClearance(ExactClearance&&) noexcept;
  ExactClearance& operator=(ExactClearance&&) noexcept;

  /// The cells `without` (indices) count as free. `solid`: what was never seen is taken for solid,
  /// which is every cell that was never observed, from zMin on, and all that lies behind a surface,
  /// to zMax: the distance is then that to the line through a cell's centre.
  void rebuild(const EnvironmentModel& model, std::span<const std::size_t> without = {},
               bool solid = false);

  /// Measured, or NothingInRange when the nearest cell is farther than `range` metres (not a
  /// number: no limit). Unknown only for what cannot be searched: NoModel before the first
  /// rebuild(), NoLoad when the box is not one (see isUsable). All other reasons are for the
  /// pipeline to say.
  Clearance query(const OrientedBox& box, double range) const;

 private:
  struct Pyramid;
  std::unique_ptr<Pyramid> m_pyramid;
};

}  // namespace boomwatch
