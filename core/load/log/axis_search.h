#pragma once

#include <array>
#include <optional>
#include <random>
#include <vector>

#include "load/load_body.h"

namespace boomwatch {

/// A line in space. Camera frame, metres.
struct LoadAxis {
  Eigen::Vector3d point;      ///< the one nearest to the tool
  Eigen::Vector3d direction;  ///< length 1
};

/// What a line along a load can be. Metres.
struct AxisLimits {
  double toolRadius;  ///< along the line, from where it passes the tool: not load, but tool
  double minArm;      ///< by which a load reaches out of that on both sides
  double farthest;    ///< from the tool point to the line: a grapple is held above its load
};

/// Lines past the tool along which the body reaches out of the tool on *both* sides, as a held log
/// does; a boom ends at the tool and so reaches out on one side only. They lie on the surface that
/// is seen.
///
/// Looks along a fan of lines in the picture: a line in space is one there, and its inverse depth
/// changes along it as a straight line does. Deterministic. Used by one thread; `patch` and `body`
/// must outlive it.
class AxisSearch {
 public:
  AxisSearch(const DepthPatch& patch, const LoadBody& body, const AxisLimits& limits);

  /// The most likely that is unlike those before. Absent when there is none.
  std::optional<LoadAxis> next();

  /// What lies within `radius` metres of the axis, up to `half` metres from `centre` along it, is
  /// no load: the next lines do not lead along it.
  void leaveOut(const Eigen::Vector3d& centre, const Eigen::Vector3d& direction, double half,
                double radius);

 private:
  /// A cell of the body: where it is seen from the tool, in cells, and where it is.
  struct Spot {
    double x, y;
    Eigen::Vector3d point;
    double q;
    double within;  ///< of q, that is allowed between it and a line that it lies on
  };
  /// A spot in a lane, `t` cells along it.
  struct Member {
    double t;
    const Spot* spot;
  };
  struct Scored {
    LoadAxis axis;
    double worth;
  };

  void sweep();
  void lookAlong(double cosine, double sine);
  void tryLane(const std::vector<Member>& lane);
  std::optional<LoadAxis> through(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
  double score(const LoadAxis& axis, const Member& a, const Member& b) const;

  Eigen::Vector3d m_tool;
  AxisLimits m_limits;
  double m_cell;  ///< metres at the tool
  std::vector<Spot> m_spots;
  bool m_swept = false;
  std::vector<Scored> m_found;  ///< the most likely last
  std::vector<LoadAxis> m_given;
  std::vector<std::vector<Member>> m_lanes;  ///< scratch, as the next
  std::array<std::vector<Member>, 2> m_sides;
  std::minstd_rand m_random{1};
};

}  // namespace boomwatch
