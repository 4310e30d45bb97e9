#include "simulation/yard/yard_obstacles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

Support supportOf(const YardGround::Triangle& triangle) {
  return [triangle](const Vector3d& direction) -> Vector3d {
    return *std::ranges::max_element(triangle, {},
                                     [&](const Vector3d& p) { return p.dot(direction); });
  };
}

/// No point of the body can be nearer to the box than this.
double minDistance(const OrientedBox& load, const Part& part) {
  const Vector3d& centre = load.centre;
  const double fromLoad = (part.box.nearestTo(centre) - centre).norm() - load.size.norm() / 2;
  const double fromPart =
      (load.nearestTo(part.box.centre) - part.box.centre).norm() - part.box.size.norm() / 2;
  return std::max(fromLoad, fromPart);
}

}  // namespace

YardApproach YardObstacles::ground(const OrientedBox& load, double limit) const {
  const YardGround& ground = m_layout->ground;
  YardApproach nearest{YardKind::Ground, {std::numeric_limits<double>::infinity(), {}, {}}};
  if (load.centre.y() >= ground.yAt(load.centre.x(), load.centre.z())) return {nearest.kind, {}};
  Eigen::AlignedBox3d around;
  for (const Vector3d& corner : load.corners()) around.extend(corner);
  if (ground.highest() - around.max().y() > limit) return nearest;
  // Nothing farther away than what lies under the load can be nearest.
  const Vector3d& c = load.centre;
  const double reach = std::min(limit, ground.yAt(c.x(), c.z()) - c.y());
  const Support support = boomwatch::supportOf(load);
  for (const auto& triangle :
       ground.triangles(around.min().x() - reach, around.max().x() + reach,
                        around.min().z() - reach, around.max().z() + reach)) {
    const Vector3d middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    double radius = 0.0;
    for (const Vector3d& corner : triangle) radius = std::max(radius, (corner - middle).norm());
    if ((load.nearestTo(middle) - middle).norm() - radius >= nearest.pair.distance) continue;
    const ConvexPair pair = nearestPair(support, supportOf(triangle));
    if (pair.distance < nearest.pair.distance) nearest.pair = pair;
  }
  return nearest;
}

YardApproach YardObstacles::nearest(const OrientedBox& load) const {
  const auto part = nearestOf(load, m_layout->fixed);
  const double limit = part ? part->pair.distance : std::numeric_limits<double>::infinity();
  const YardApproach below = ground(load, limit);
  return part && limit <= below.pair.distance ? *part : below;
}

std::vector<YardApproach> YardObstacles::all(const OrientedBox& load) const {
  std::vector<YardApproach> all{ground(load, std::numeric_limits<double>::infinity())};
  const Support support = supportOf(load);
  for (const Part& part : m_layout->fixed) {
    all.push_back({part.kind, nearestPair(support, supportOf(part))});
  }
  return all;
}

std::optional<YardApproach> nearestOf(const OrientedBox& load, const Parts& parts) {
  if (parts.empty()) return std::nullopt;
  std::vector<std::pair<double, const Part*>> order;
  for (const Part& part : parts) order.emplace_back(minDistance(load, part), &part);
  std::ranges::sort(order, {}, &std::pair<double, const Part*>::first);
  YardApproach nearest{YardKind::Nothing, {std::numeric_limits<double>::infinity(), {}, {}}};
  const Support support = supportOf(load);
  for (const auto& [least, part] : order) {
    if (least >= nearest.pair.distance) break;
    const ConvexPair pair = nearestPair(support, supportOf(*part));
    if (pair.distance < nearest.pair.distance) nearest = {part->kind, pair};
  }
  return nearest;
}

}  // namespace boomwatch
