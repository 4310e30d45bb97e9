#include "simulation/yard/crane_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace boomwatch {

using Eigen::Vector3d;

/// Finds the stops.
class CranePath::Planner {
 public:
  Planner(const YardLayout& layout, std::uint64_t seed, YardPath kind)
      : m_layout(layout), m_obstacles(layout), m_dice(seed, 3), m_kind(kind) {}

  std::vector<Stop> plan(double duration) {
    std::vector<Stop> stops{freeStop()};
    while (stops.back().time < duration) {
      const Stop approach = approachFrom(stops.back());
      go(stops, approach);
      const Stop away = freeStop();
      // Back where it came from is always a way out.
      go(stops, isFree(approach, away) ? away : stops[stops.size() - 2]);
    }
    return stops;
  }

 private:
  static constexpr double roomy = 1.2;   // metres around a load on its way
  static constexpr double speed = 0.65;  // m/s on average
  static constexpr double turning = 0.5;

  OrientedBox boxAt(const Stop& stop) const {
    const CarriedLog& log = m_layout.log;
    return loadBoxOf(logAt({stop.load - Vector3d(0, log.drop(), 0), stop.yaw, 0.0, 0.0}, log));
  }

  double clearance(const Stop& stop) const {
    return m_obstacles.nearest(boxAt(stop)).pair.distance;
  }

  /// Before the lane where people walk, and well within the picture.
  bool isInReach(const Stop& stop) const {
    return std::ranges::all_of(boxAt(stop).corners(), [](const Vector3d& p) {
      return p.z() > 3.6 && p.z() < 8.0 && std::abs(p.x()) < 0.54 * p.z() && p.y() > 0.2 &&
             p.y() < 0.80 * p.z();
    });
  }

  /// A random place with nothing near it.
  Stop freeStop() {
    for (int attempt = 0; attempt < 2000; ++attempt) {
      Stop stop;
      const double z = m_dice.uniform(4.2, 7.6), x = m_dice.uniform(-0.45, 0.45) * z;
      const double height = m_dice.uniform(0.8, 2.3);
      stop.load = {x, m_layout.ground.yAt(x, z) - height, z};
      stop.yaw = m_dice.uniform(-1.5, 1.5);
      if (isInReach(stop) && clearance(stop) > (attempt < 500 ? roomy : 2.0 * margin)) return stop;
    }
    return {0.0, {0.0, 1.4, 5.0}, 1.2};  // amid the yard, where nothing is planted
  }

  bool isFree(const Stop& from, const Stop& to) const {
    constexpr int samples = 12;
    for (int k = 1; k < samples; ++k) {
      const double share = static_cast<double>(k) / samples;
      Stop between;
      between.load = from.load + share * (to.load - from.load);
      between.yaw = from.yaw + share * (to.yaw - from.yaw);
      // Between two samples it moves less than what is added.
      if (clearance(between) < 2.0 * margin) return false;
    }
    return true;
  }

  YardKind nextKind() {
    constexpr std::array kinds{YardKind::Stack, YardKind::Wall, YardKind::Ground, YardKind::Tree};
    const int next = m_kind == YardPath::Random ? m_dice.below(4) : m_turn++ % 4;
    return kinds[static_cast<std::size_t>(next)];
  }

  /// Straight towards a thing of the next kind, up to the distance at which it is to stop.
  Stop approachFrom(const Stop& start) {
    const OrientedBox box = boxAt(start);
    const double wanted = m_dice.uniform(0.35, 1.15);
    for (int attempt = 0; attempt < 8; ++attempt) {
      const YardKind kind = nextKind();
      YardApproach goal{kind, {1e9, {}, {}}};
      for (const YardApproach& thing : m_obstacles.all(box)) {
        if (thing.kind == kind && thing.pair.distance < goal.pair.distance) goal = thing;
      }
      if (goal.pair.distance > 6.0 || goal.pair.distance <= wanted) continue;
      Stop stop = start;
      stop.load += (goal.pair.onB - goal.pair.onA) * (1.0 - wanted / goal.pair.distance);
      if (isInReach(stop) && clearance(stop) > 1.5 * margin && isFree(start, stop)) return stop;
    }
    Stop down = start;
    down.load.y() += std::max(0.0, clearance(start) - wanted);
    return down;
  }

  void go(std::vector<Stop>& stops, Stop next) const {
    const Stop& last = stops.back();
    const double way = (next.load - last.load).norm() / speed;
    next.time = last.time + std::max({way, std::abs(next.yaw - last.yaw) / turning, 1.0});
    stops.push_back(next);
  }

  const YardLayout& m_layout;
  YardObstacles m_obstacles;
  Dice m_dice;
  YardPath m_kind;
  int m_turn = 0;
};

CranePath::CranePath(const YardLayout& layout, std::uint64_t seed, YardPath kind, double duration)
    : m_drop(layout.log.drop()), m_stops(Planner(layout, seed, kind).plan(duration)) {}

CranePose CranePath::at(double time) const {
  const double within = std::fmod(std::max(0.0, time), m_stops.back().time);
  const auto next = std::ranges::upper_bound(m_stops, within, {}, &Stop::time);
  const Stop& to = next == m_stops.end() ? m_stops.back() : *next;
  const Stop& from = *(next - 1);
  const double share = std::clamp((within - from.time) / (to.time - from.time), 0.0, 1.0);
  const double eased = share * share * share * (10.0 - 15.0 * share + 6.0 * share * share);
  const Vector3d load = from.load + eased * (to.load - from.load);
  CranePose pose;
  pose.tip = load - Vector3d(0.0, m_drop, 0.0);
  pose.yaw = from.yaw + eased * (to.yaw - from.yaw);
  // A pendulum of the grapple's length.
  pose.swingX = 0.022 * std::sin(2.8 * time);
  pose.swingZ = 0.018 * std::sin(2.6 * time + 1.0);
  return pose;
}

OrientedBox loadBoxOf(const Part& log) {
  const OrientedBox& box = log.box;
  OrientedBox load{box.centre, {box.size.y(), box.size.x(), box.size.z()}, {}};
  load.rotation << box.rotation.col(1), -box.rotation.col(0), box.rotation.col(2);
  return load;
}

}  // namespace boomwatch
