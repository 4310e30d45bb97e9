#include "load/axis_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <random>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

/// A cell outside the tool.
struct Outer {
  Vector3d point;
  double depthNoise;  ///< metres
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
    constexpr int widestGap = 3;
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
  static constexpr int bins = 100;
  std::array<int, bins> m_counts{};
};

class Search {
 public:
  Search(const DepthPatch& patch, const LoadBody& body, double toolRadius, double leastArm)
      : m_tool(body.tool),
        m_radius(toolRadius),
        m_cell(patch.cell * body.tool.z()),
        m_leastArm(leastArm) {
    for (std::size_t i = 0; i < body.points.size(); ++i) {
      const Vector3d& p = body.points[i];
      if ((p - m_tool).norm() <= toolRadius) continue;
      const double sigma = patch.sigma[static_cast<std::size_t>(body.cells[i])];
      m_outer.push_back({p, sigma * p.z() * p.z()});
    }
  }

  std::vector<LoadAxis> best() {
    constexpr int draws = 6000, mostTried = 500;
    if (m_outer.size() < 2) return {};
    std::minstd_rand random(1);
    std::uniform_int_distribution<std::size_t> pick(0, m_outer.size() - 1);
    std::vector<Scored> found;
    for (int draw = 0, tried = 0; draw < draws && tried < mostTried; ++draw) {
      const auto axis = through(m_outer[pick(random)].point, m_outer[pick(random)].point);
      if (!axis) continue;
      ++tried;
      const double worth = score(*axis);
      if (worth > 0.0) found.push_back({*axis, worth});
    }
    return distinct(found);
  }

 private:
  struct Scored {
    LoadAxis axis;
    double worth;
  };

  static std::vector<LoadAxis> distinct(std::vector<Scored>& found) {
    constexpr std::size_t most = 5;
    constexpr double sameDirection = 0.97;  // cosine of 14 degrees
    std::sort(found.begin(), found.end(),
              [](const Scored& a, const Scored& b) { return a.worth > b.worth; });
    std::vector<LoadAxis> axes;
    for (const Scored& next : found) {
      const bool known = std::any_of(axes.begin(), axes.end(), [&](const LoadAxis& axis) {
        return std::abs(axis.direction.dot(next.axis.direction)) > sameDirection;
      });
      if (!known) axes.push_back(next.axis);
      if (axes.size() == most) break;
    }
    return axes;
  }

  /// Of two points on opposite sides of the tool, the line past it.
  std::optional<LoadAxis> through(const Vector3d& a, const Vector3d& b) const {
    constexpr double opposite = -0.3;
    const Vector3d fromTool = a - m_tool, across = b - m_tool;
    if (fromTool.dot(across) > opposite * fromTool.norm() * across.norm()) return std::nullopt;
    const Vector3d direction = (b - a).normalized();
    const Vector3d foot = a + direction * direction.dot(m_tool - a);
    if ((foot - m_tool).norm() > std::max(m_radius, 4.0 * m_cell)) return std::nullopt;
    return LoadAxis{foot, direction};
  }

  /// The points on the lesser arm, and a little for the other; 0 when one arm is too short.
  double score(const LoadAxis& axis) {
    const Vector3d view = axis.point.normalized();
    const Vector3d across = axis.direction.cross(view);
    if (across.norm() < 1e-6) return 0.0;
    const Vector3d side = across.normalized(), up = side.cross(axis.direction);
    const double rim2 = m_radius * m_radius - (axis.point - m_tool).squaredNorm();
    const double rim = std::sqrt(std::max(0.0, rim2));
    const double band = 3.0 * m_cell, bin = 2.0 * m_cell;
    const std::size_t step = 1 + m_outer.size() / mostScored;
    m_arms[0].clear(), m_arms[1].clear();
    for (std::size_t i = 0; i < m_outer.size(); i += step) {
      const Vector3d offset = m_outer[i].point - axis.point;
      if (std::abs(side.dot(offset)) > band) continue;
      if (std::abs(up.dot(offset)) > band + 3.0 * m_outer[i].depthNoise) continue;
      const double along = axis.direction.dot(offset);
      m_arms[along < 0.0 ? 0 : 1].add(std::abs(along) - rim, bin);
    }
    const Arm::Run left = m_arms[0].run(), right = m_arms[1].run();
    if (std::min(left.length, right.length) * bin < m_leastArm) return 0.0;
    return std::min(left.points, right.points) + 0.1 * std::max(left.points, right.points);
  }

  static constexpr std::size_t mostScored = 800;
  Vector3d m_tool;
  double m_radius;
  double m_cell;
  double m_leastArm;
  std::vector<Outer> m_outer;
  std::array<Arm, 2> m_arms;
};

}  // namespace

std::vector<LoadAxis> findAxes(const DepthPatch& patch, const LoadBody& body, double toolRadius,
                               double leastArm) {
  return Search(patch, body, toolRadius, leastArm).best();
}

}  // namespace boomwatch
