#pragma once

#include "simulation/yard/part.h"
#include "simulation/yard/yard_ground.h"

namespace boomwatch {

/// Someone who walks to and fro across the yard. Yard frame.
struct Walk {
  std::vector<Eigen::Vector2d> corners;  ///< x and z of a closed way
  double speed = 1.1;                    ///< metres a second
  double start = 0.0;                    ///< metres along the way at time 0

  /// Where they are (x, z), and which way they look (length 1).
  std::pair<Eigen::Vector2d, Eigen::Vector2d> at(double time) const;
};

/// The person at a time, with swinging arms and legs.
Parts personAt(const Walk& walk, const YardGround& ground, double time);

}  // namespace boomwatch
