#include "load/log/axis_search.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "load/log/log_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr LogTuning::Axis tuning;

/// Counts, bin by bin, what lies along one direction from the tool's rim outwards.
class Arm {
 public:
  void add(double beyondRim, double bin) {
    const double index = beyondRim / bin;
    if (index >= 0.0 && index < bins) ++m_counts[static_cast<std::size_t>(index)];
  }
  struct Run {
    int length = 0;  ///< bins until a gap
    int points = 0;
  };
  Run run() const {
    Run run;
    int gap = 0;
    for (int i = 0; i < bins && gap <= tuning.maxGap; ++i) {
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

}  // namespace

AxisSearch::AxisSearch(const DepthPatch& patch, const LoadBody& body, const AxisLimits& limits)
    : m_tool(body.tool), m_limits(limits), m_cell(patch.cell * body.tool.z()) {
  const std::size_t step = 1 + body.cells.size() / tuning.maxSpots;
  const double u = body.tool.x() / body.tool.z(), v = body.tool.y() / body.tool.z();
  for (std::size_t i = 0; i < body.cells.size(); i += step) {
    const int cell = body.cells[i];
    const double q = patch.q[static_cast<std::size_t>(cell)];
    m_spots.push_back({(patch.u0 - u) / patch.cell + cell % patch.side + 0.5,
                       (patch.v0 - v) / patch.cell + cell / patch.side + 0.5, body.points[i], q,
                       tuning.deviations * patch.sigma[static_cast<std::size_t>(cell)] +
                           tuning.thickness * q * q});
  }
}

std::optional<LoadAxis> AxisSearch::next() {
  if (!m_swept) sweep();
  while (!m_found.empty()) {
    const LoadAxis next = m_found.back().axis;
    m_found.pop_back();
    const bool known = std::any_of(m_given.begin(), m_given.end(), [&](const LoadAxis& axis) {
      return std::abs(axis.direction.dot(next.direction)) > tuning.sameDirection &&
             (axis.point - next.point).norm() < tuning.samePlace;
    });
    if (known) continue;
    m_given.push_back(next);
    return next;
  }
  return std::nullopt;
}

void AxisSearch::leaveOut(const Vector3d& centre, const Vector3d& direction, double half,
                          double radius) {
  std::erase_if(m_spots, [&](const Spot& spot) {
    const Vector3d offset = spot.point - centre;
    const double along = direction.dot(offset), z = spot.point.z();
    const double within = radius + m_cell + spot.within * z * z;
    return std::abs(along) < half + m_cell &&
           (offset - along * direction).squaredNorm() < within * within;
  });
  m_swept = false;
}

void AxisSearch::sweep() {
  m_found.clear();
  for (int k = 0; k < tuning.directions; ++k) {
    const double turn = M_PI * k / tuning.directions;
    lookAlong(std::cos(turn), std::sin(turn));
  }
  std::sort(m_found.begin(), m_found.end(),
            [](const Scored& a, const Scored& b) { return a.worth < b.worth; });
  m_swept = true;
}

/// Cuts the picture into lanes of this direction.
void AxisSearch::lookAlong(double cosine, double sine) {
  const int half = static_cast<int>(m_limits.farthest / m_cell / tuning.laneWidth) + 1;
  m_lanes.resize(static_cast<std::size_t>(2 * half + 1));
  for (auto& lane : m_lanes) lane.clear();
  for (const Spot& spot : m_spots) {
    const double across = (spot.y * cosine - spot.x * sine) / tuning.laneWidth + half + 0.5;
    if (!(across >= 0.0 && across < static_cast<double>(m_lanes.size()))) continue;
    m_lanes[static_cast<std::size_t>(across)].push_back({spot.x * cosine + spot.y * sine, &spot});
  }
  for (const auto& lane : m_lanes) tryLane(lane);
}

/// Of lines through two of the lane's spots, one on either side of the tool, the best.
void AxisSearch::tryLane(const std::vector<Member>& lane) {
  for (auto& side : m_sides) side.clear();
  for (const Member& m : lane) {
    if (std::abs(m.t) > tuning.middle) m_sides[m.t < 0.0 ? 0 : 1].push_back(m);
  }
  if (m_sides[0].size() < tuning.minMembers || m_sides[1].size() < tuning.minMembers) return;
  std::optional<Scored> best;
  for (int k = 0; k < tuning.draws; ++k) {
    const Member& a = m_sides[0][m_random() % m_sides[0].size()];
    const Member& b = m_sides[1][m_random() % m_sides[1].size()];
    const auto axis = through(a.spot->point, b.spot->point);
    if (!axis) continue;
    const double worth = score(*axis, a, b);
    if (worth > 0.0 && (!best || worth > best->worth)) best = Scored{*axis, worth};
  }
  if (best) m_found.push_back(*best);
}

/// Of two points on opposite sides of the tool, the line past it.
std::optional<LoadAxis> AxisSearch::through(const Vector3d& a, const Vector3d& b) const {
  const Vector3d direction = (b - a).normalized();
  const double toA = direction.dot(a - m_tool), toB = direction.dot(b - m_tool);
  if (!(toA < -m_limits.toolRadius && toB > m_limits.toolRadius)) return std::nullopt;
  const Vector3d foot = a - direction * toA;
  if ((foot - m_tool).squaredNorm() > m_limits.farthest * m_limits.farthest) return std::nullopt;
  return LoadAxis{foot, direction};
}

/// The points on the lesser arm, and a little for the other; 0 when one arm is too short.
double AxisSearch::score(const LoadAxis& axis, const Member& a, const Member& b) const {
  const double slope = (b.spot->q - a.spot->q) / (b.t - a.t), bin = tuning.binCells * m_cell;
  std::array<Arm, 2> arms;
  for (const auto& side : m_sides) {
    for (const Member& m : side) {
      if (std::abs(a.spot->q + slope * (m.t - a.t) - m.spot->q) > m.spot->within) continue;
      const double along = axis.direction.dot(m.spot->point - axis.point);
      arms[along < 0.0 ? 0 : 1].add(std::abs(along) - m_limits.toolRadius, bin);
    }
  }
  const Arm::Run left = arms[0].run(), right = arms[1].run();
  if (std::min(left.length, right.length) * bin < m_limits.minArm) return 0.0;
  return std::min(left.points, right.points) +
         tuning.longerArm * std::max(left.points, right.points);
}

}  // namespace boomwatch
