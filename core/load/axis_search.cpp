#include "load/axis_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <random>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

/// A cell of the body: where it is seen from the tool, in cells, and where it is.
struct Spot {
  double x, y;
  Vector3d point;
  double q;
  double within;  ///< of q, that is allowed between it and a line that it lies on
};

/// Counts, bin by bin, what lies along one direction from the tool's rim outwards.
class Arm {
 public:
  void clear() { m_counts.fill(0); }
  void add(double beyondRim, double bin) {
    const double index = beyondRim / bin;
    if (index >= 0.0 && index < bins) ++m_counts[static_cast<std::size_t>(index)];
  }
  struct Run {
    int length = 0;  ///< bins until a gap
    int points = 0;
  };
  Run run() const {
    constexpr int widestGap = 4;
    Run run;
    int gap = 0;
    for (int i = 0; i < bins && gap <= widestGap; ++i) {
      const int count = m_counts[static_cast<std::size_t>(i)];
      gap = count == 0 ? gap + 1 : 0;
      if (count > 0) run = {i + 1, run.points + count};
    }
    return run;
  }

 private:
  static constexpr int bins = 80;
  std::array<int, bins> m_counts{};
};

class Search {
 public:
  Search(const DepthPatch& patch, const LoadBody& body, const AxisLimits& limits)
      : m_tool(body.tool), m_limits(limits), m_cell(patch.cell * body.tool.z()) {
    constexpr std::size_t most = 2500;
    constexpr double deviations = 2.5, thickness = 0.04;
    const std::size_t step = 1 + body.cells.size() / most;
    const double u = body.tool.x() / body.tool.z(), v = body.tool.y() / body.tool.z();
    for (std::size_t i = 0; i < body.cells.size(); i += step) {
      const int cell = body.cells[i];
      const double q = patch.q[static_cast<std::size_t>(cell)];
      m_spots.push_back({(patch.u0 - u) / patch.cell + cell % patch.side + 0.5,
                         (patch.v0 - v) / patch.cell + cell / patch.side + 0.5, body.points[i], q,
                         deviations * patch.sigma[static_cast<std::size_t>(cell)] +
                             thickness * q * q});
    }
  }

  std::vector<LoadAxis> best() {
    constexpr int directions = 48;
    std::vector<Scored> found;
    for (int k = 0; k < directions; ++k) {
      const double turn = M_PI * k / directions;
      lookAlong(std::cos(turn), std::sin(turn), found);
    }
    return distinct(found);
  }

 private:
  struct Scored {
    LoadAxis axis;
    double worth;
  };
  /// A spot in a lane, `t` cells along it.
  struct Member {
    double t;
    const Spot* spot;
  };

  static std::vector<LoadAxis> distinct(std::vector<Scored>& found) {
    constexpr std::size_t most = 6;
    constexpr double sameDirection = 0.97;  // cosine of 14 degrees
    constexpr double samePlace = 0.3;
    std::sort(found.begin(), found.end(),
              [](const Scored& a, const Scored& b) { return a.worth > b.worth; });
    std::vector<LoadAxis> axes;
    for (const Scored& next : found) {
      const bool known = std::any_of(axes.begin(), axes.end(), [&](const LoadAxis& axis) {
        return std::abs(axis.direction.dot(next.axis.direction)) > sameDirection &&
               (axis.point - next.axis.point).norm() < samePlace;
      });
      if (!known) axes.push_back(next.axis);
      if (axes.size() == most) break;
    }
    return axes;
  }

  /// Cuts the picture into lanes of this direction.
  void lookAlong(double cosine, double sine, std::vector<Scored>& found) {
    constexpr double width = 2.0;  // cells
    const int half = static_cast<int>(m_limits.farthest / m_cell / width) + 1;
    m_lanes.resize(static_cast<std::size_t>(2 * half + 1));
    for (auto& lane : m_lanes) lane.clear();
    for (const Spot& spot : m_spots) {
      const int lane =
          static_cast<int>((spot.y * cosine - spot.x * sine) / width + half + 1000.5) - 1000;
      if (lane < 0 || lane > 2 * half) continue;
      m_lanes[static_cast<std::size_t>(lane)].push_back({spot.x * cosine + spot.y * sine, &spot});
    }
    for (auto& lane : m_lanes) tryLane(lane, found);
  }

  /// Of lines through two of the lane's spots, one on either side of the tool, the best.
  void tryLane(std::vector<Member>& lane, std::vector<Scored>& found) {
    constexpr int draws = 12;
    constexpr std::size_t fewest = 3;
    constexpr double middle = 2.0;  // cells: surely the tool's
    m_sides[0].clear(), m_sides[1].clear();
    for (const Member& m : lane) {
      if (std::abs(m.t) > middle) m_sides[m.t < 0.0 ? 0 : 1].push_back(m);
    }
    if (m_sides[0].size() < fewest || m_sides[1].size() < fewest) return;
    std::optional<Scored> best;
    for (int k = 0; k < draws; ++k) {
      const Member& a = m_sides[0][m_random() % m_sides[0].size()];
      const Member& b = m_sides[1][m_random() % m_sides[1].size()];
      const auto axis = through(a.spot->point, b.spot->point);
      if (!axis) continue;
      const double worth = score(*axis, a, b);
      if (worth > 0.0 && (!best || worth > best->worth)) best = Scored{*axis, worth};
    }
    if (best) found.push_back(*best);
  }

  /// Of two points on opposite sides of the tool, the line past it.
  std::optional<LoadAxis> through(const Vector3d& a, const Vector3d& b) const {
    const Vector3d direction = (b - a).normalized();
    const double toA = direction.dot(a - m_tool), toB = direction.dot(b - m_tool);
    if (!(toA < -m_limits.toolRadius && toB > m_limits.toolRadius)) return std::nullopt;
    const Vector3d foot = a - direction * toA;
    if ((foot - m_tool).squaredNorm() > m_limits.farthest * m_limits.farthest) return std::nullopt;
    return LoadAxis{foot, direction};
  }

  /// The points on the lesser arm, and a little for the other; 0 when one arm is too short.
  double score(const LoadAxis& axis, const Member& a, const Member& b) {
    const double slope = (b.spot->q - a.spot->q) / (b.t - a.t), bin = 2.0 * m_cell;
    m_arms[0].clear(), m_arms[1].clear();
    for (const auto& side : m_sides) {
      for (const Member& m : side) {
        if (std::abs(a.spot->q + slope * (m.t - a.t) - m.spot->q) > m.spot->within) continue;
        const double along = axis.direction.dot(m.spot->point - axis.point);
        m_arms[along < 0.0 ? 0 : 1].add(std::abs(along) - m_limits.toolRadius, bin);
      }
    }
    const Arm::Run left = m_arms[0].run(), right = m_arms[1].run();
    if (std::min(left.length, right.length) * bin < m_limits.leastArm) return 0.0;
    return std::min(left.points, right.points) + 0.1 * std::max(left.points, right.points);
  }

  Vector3d m_tool;
  AxisLimits m_limits;
  double m_cell;
  std::vector<Spot> m_spots;
  std::vector<std::vector<Member>> m_lanes;  ///< scratch, as the next
  std::array<std::vector<Member>, 2> m_sides;
  std::array<Arm, 2> m_arms;
  std::minstd_rand m_random{1};
};

}  // namespace

std::vector<LoadAxis> findAxes(const DepthPatch& patch, const LoadBody& body,
                               const AxisLimits& limits) {
  return Search(patch, body, limits).best();
}

}  // namespace boomwatch
