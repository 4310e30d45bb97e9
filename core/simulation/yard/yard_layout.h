#pragma once

#include "simulation/yard/crane.h"
#include "simulation/yard/dice.h"
#include "simulation/yard/walk.h"

namespace boomwatch {

/// A branch with leaves that swings about the place where it grows. Yard frame.
struct Bough {
  Eigen::Vector3d root;
  Eigen::Vector3d axis;  ///< length 1
  double swing = 0.05;   ///< radians to both sides
  double period = 2.5, phase = 0.0;
  Parts parts;  ///< at rest
};

/// Everything in the yard that has its place. Yard frame: as the camera's, but level; metres.
struct YardLayout {
  explicit YardLayout(std::uint64_t seed);

  YardGround ground;
  Parts fixed;  ///< trees, stacks of logs, wall
  std::vector<Bough> boughs;
  Walk walk;
  Crane crane;
  CarriedLog log;
};

/// The boughs at a time.
Parts boughsAt(const std::vector<Bough>& boughs, double time);

}  // namespace boomwatch
