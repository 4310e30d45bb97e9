#pragma once

#include "simulation/yard/yard_obstacles.h"

namespace boomwatch {

/// How the crane goes about its work.
enum class YardPath { Scripted, Random };

/// The way of the load through the yard: legs along straight lines, each with a gentle start and
/// end. Every other leg brings the load near something: into the warning zone of 1 m or just out of
/// it, but never nearer than `margin`.
class CranePath {
 public:
  static constexpr double margin = 0.2;  ///< metres that the load keeps from everything static

  /// Scripted: stack, wall, ground, tree and stack in turn, over and over. Random: any of them.
  CranePath(const YardLayout& layout, std::uint64_t seed, YardPath kind, double duration);

  /// Seconds from 0; after the end the path begins anew.
  CranePose at(double time) const;

 private:
  struct Stop {
    double time = 0.0;
    Eigen::Vector3d load = Eigen::Vector3d::Zero();  ///< the log's centre
    double yaw = 0.0;
  };
  class Planner;

  double m_drop = 0.0;  ///< from the boom's tip to the log's centre
  std::vector<Stop> m_stops;
};

/// The load's box, its x along the log. Same frame as the part.
OrientedBox loadBoxOf(const Part& log);

}  // namespace boomwatch
