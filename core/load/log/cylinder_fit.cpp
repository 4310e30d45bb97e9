#include "load/log/cylinder_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "load/log/cylinder_ends.h"
#include "load/log/cylinder_strip.h"
#include "load/log/log_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;
using Vector5 = Eigen::Matrix<double, ViewedCylinder::parameters, 1>;
using Matrix5 = Eigen::Matrix<double, ViewedCylinder::parameters, ViewedCylinder::parameters>;

constexpr LogTuning::Fit tuning;

/// What is expected, in a frame; within how much.
struct Expected {
  NearLine axis;
  double radius;
};

/// What a cylinder is measured by.
struct Evidence {
  const CylinderStrip& strip;
  const DepthPatch& patch;
  std::optional<Expected> expected;
};

void addExpected(const Expected& expected, const ViewedCylinder& cylinder,
                 std::vector<double>& out) {
  const NearLine& axis = expected.axis;
  for (const double u : {axis.ua, axis.ub}) {
    const double q = axis.q(u);
    out.push_back((cylinder.axisV(u) - axis.v(u)) / (tuning.aside * q));
    out.push_back((cylinder.axisQ(u) - q) / (tuning.deep * q * q));
  }
  out.push_back((cylinder.radius() - expected.radius) / (tuning.thick * expected.radius));
}

/// Residuals in standard deviations: depths first, then the edges, then what is expected.
void residuals(const Evidence& evidence, const ViewedCylinder& cylinder, std::vector<double>& out) {
  const CylinderStrip& strip = evidence.strip;
  const DepthPatch& patch = evidence.patch;
  out.clear();
  const CylinderOutline outline(cylinder);
  for (const CylinderStrip::Surface& s : strip.surface) {
    const double noise = patch.noise * std::sqrt(1.0 / s.count + tuning.shared * tuning.shared);
    const double sigma = std::hypot(noise, tuning.roughness * s.q * s.q);
    out.push_back((outline.q(s.u, s.v) - s.q) / sigma);
  }
  for (const CylinderStrip::Edge& e : strip.edges) {
    out.push_back((outline.edge(e.u, e.upper) - e.v) / patch.pitch);
  }
  if (evidence.expected) addExpected(*evidence.expected, cylinder, out);
}

double costOf(const std::vector<double>& residuals) {
  double sum = 0.0;
  for (const double x : residuals) sum += std::log1p(x * x / tuning.soft);
  return sum;
}

/// Levenberg-Marquardt; beyond about two standard deviations a residual pulls less and less.
bool refine(const Evidence& evidence, ViewedCylinder& cylinder) {
  std::vector<double> now, moved;
  Eigen::Matrix<double, Eigen::Dynamic, ViewedCylinder::parameters> slope;
  residuals(evidence, cylinder, now);
  if (now.size() < 10) return false;
  slope.resize(static_cast<Eigen::Index>(now.size()), ViewedCylinder::parameters);
  double damping = 1e-3, best = costOf(now);
  for (int k = 0; k < tuning.iterations; ++k) {
    for (int j = 0; j < ViewedCylinder::parameters; ++j) {
      ViewedCylinder nudged = cylinder;
      const double step = 1e-5 * std::max(0.01, std::abs(cylinder.x[j]));
      nudged.x[j] += step;
      residuals(evidence, nudged, moved);
      for (std::size_t i = 0; i < now.size(); ++i) {
        slope(static_cast<Eigen::Index>(i), j) = (moved[i] - now[i]) / step;
      }
    }
    Matrix5 left = Matrix5::Zero();
    Vector5 right = Vector5::Zero();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Vector5 row = slope.row(static_cast<Eigen::Index>(i)).transpose();
      const double weight = 1.0 / (1.0 + now[i] * now[i] / tuning.soft);
      left += weight * row * row.transpose();
      right -= weight * row * now[i];
    }
    left.diagonal() *= 1.0 + damping;
    ViewedCylinder tried = cylinder;
    tried.x += left.ldlt().solve(right);
    if (!tried.isUsable()) {
      damping *= 10.0;
      continue;
    }
    residuals(evidence, tried, moved);
    const double cost2 = costOf(moved);
    if (!(cost2 < best)) {
      damping *= 10.0;
      continue;
    }
    const bool settled = best - cost2 < 1e-4 * best;
    cylinder = tried, best = cost2, now.swap(moved);
    damping *= 0.2;
    if (settled) break;
  }
  return cylinder.isUsable();
}

/// Of the strip's own guess and what was found before, the one that it agrees with better.
void chooseStart(CylinderStrip& strip, const Evidence& evidence, const CylinderFrame& frame,
                 const CylinderFit& before) {
  ViewedCylinder known = strip.guess;
  const NearLine axis = NearLine::fromAxis(frame, {before.centre, before.axis});
  known.x << axis.v(known.ua), axis.v(known.ub), axis.q(known.ua), axis.q(known.ub), before.radius;
  if (!known.isUsable()) return;
  std::vector<double> ofGuess, ofKnown;
  residuals(evidence, strip.guess, ofGuess);
  residuals(evidence, known, ofKnown);
  if (costOf(ofKnown) < costOf(ofGuess)) strip.guess = known;
}

/// Whether what was fitted is round and there: depths and both edges agree with it.
bool agrees(const Evidence& evidence, const ViewedCylinder& cylinder) {
  const CylinderStrip& strip = evidence.strip;
  std::vector<double> all;
  residuals(evidence, cylinder, all);
  std::array<int, 3> good{}, count{};  // depths, lower edge, upper edge
  for (std::size_t i = 0; i < strip.surface.size() + strip.edges.size(); ++i) {
    const std::size_t edge = i - std::min(i, strip.surface.size());
    const std::size_t kind = i < strip.surface.size() ? 0 : strip.edges[edge].upper ? 2 : 1;
    ++count[kind];
    if (std::abs(all[i]) < tuning.within) ++good[kind];
  }
  for (std::size_t kind = 0; kind < 3; ++kind) {
    if (count[kind] < tuning.minCount || good[kind] < tuning.minShare * count[kind]) return false;
  }
  return true;
}

CylinderFit refused(LoadFault fault) {
  CylinderFit fit;
  fit.fault = fault;
  return fit;
}

/// On what is seen of it, in the camera's frame.
CylinderFit inCamera(const CylinderFrame& frame, const ViewedCylinder& cylinder,
                     const CylinderEnds& ends, const Vector3d& tool, double toolRadius) {
  CylinderFit fit;
  const std::array<double, 2> at{CylinderEnds::alongAxis(cylinder, ends.u[0]),
                                 CylinderEnds::alongAxis(cylinder, ends.u[1])};
  const double foot = cylinder.direction().dot(tool - cylinder.pointA());
  fit.axis = frame.toCamera(cylinder.direction());
  fit.centre = frame.toCamera(cylinder.pointA()) + fit.axis * (at[0] + at[1]) / 2.0;
  fit.length = at[1] - at[0];
  fit.radius = cylinder.radius();
  fit.endSeen = ends.seen;
  const double scale = fit.length / std::max(1e-9, ends.u[1] - ends.u[0]);
  for (const std::size_t side : {0U, 1U}) {
    const double outwards = side == 0 ? -1.0 : 1.0;
    fit.arm[side] = outwards * (at[side] - foot) - toolRadius;
    fit.shown[side] = ends.shown[side] * scale;
    fit.hidden[side] =
        outwards * (CylinderEnds::alongAxis(cylinder, ends.farthest[side]) - at[side]);
  }
  return fit;
}

std::optional<Expected> expectedIn(const CylinderFrame& frame, const CylinderLimits& limits) {
  if (!limits.expected) return std::nullopt;
  const auto a = frame.look(limits.expected->from), b = frame.look(limits.expected->to);
  if (!(a.q > 0.0 && b.q > 0.0)) return std::nullopt;
  return Expected{{a.u, b.u, a.v, b.v, a.q, b.q}, limits.expected->radius};
}

/// How far past an end is looked, for what is no longer the log: some cells of the picture, which
/// is a long way along what points at the camera. Metres.
double pastEnd(const DepthPatch& patch, const LoadAxis& start) {
  const double sine = start.direction.cross(start.point.normalized()).norm();
  return std::max(tuning.pastEnd, tuning.pastCells * patch.cell * start.point.norm() /
                                      std::max(sine, tuning.minSine));
}

}  // namespace

CylinderFit fitCylinder(const DepthPatch& patch, const Vector3d& tool, const LoadAxis& start,
                        const CylinderLimits& limits) {
  LoadAxis surface = start;
  CylinderStrip::Limits around{
      limits.maxRadius, limits.minRadius, limits.maxRadius, {limits.toolRadius}};
  AlongRange range{limits.toolRadius};
  if (limits.expected) {
    const ExpectedCylinder& expected = *limits.expected;
    around.halfWidth = tuning.halfWidth * expected.radius + tuning.room;
    const double beyond = pastEnd(patch, start);
    range.from = start.direction.dot(expected.from - tool) - beyond;
    range.to = start.direction.dot(expected.to - tool) + beyond;
    around.along = range;
  }
  CylinderFit fit;
  for (int round = 0; round < tuning.rounds; ++round) {
    const auto frame = CylinderFrame::facing(surface.point, surface.direction, limits.endOn);
    if (!frame) return refused(LoadFault::EndOn);
    const Vector3d local = frame->toLocal(tool);
    auto strip = cutStrip(patch, *frame, NearLine::fromAxis(*frame, surface), local, around);
    if (!strip) return refused(LoadFault::FewPoints);
    const Evidence evidence{*strip, patch, expectedIn(*frame, limits)};
    if (round > 0) chooseStart(*strip, evidence, *frame, fit);
    ViewedCylinder& cylinder = strip->guess;
    if (!refine(evidence, cylinder)) return refused(LoadFault::PoorFit);
    if (cylinder.radius() > limits.maxRadius) return refused(LoadFault::TooLarge);
    const CylinderEnds ends = findEnds(patch, *frame, cylinder, local, range);
    fit = inCamera(*frame, cylinder, ends, local, limits.toolRadius);
    if (!(fit.length > tuning.minAspect * 2.0 * fit.radius)) return refused(LoadFault::NoBody);
    if (round + 1 == tuning.rounds &&
        (!agrees(evidence, cylinder) || ends.filled < tuning.minFilled ||
         strip->outlined < tuning.minOutlined)) {
      return refused(LoadFault::PoorFit);
    }
    const Vector3d away = fit.centre - fit.axis * fit.axis.dot(fit.centre);
    surface = {fit.centre - away.normalized() * fit.radius, fit.axis};
    around.halfWidth = tuning.halfWidth * fit.radius + tuning.room;
    around.along.from = -fit.arm[0] - limits.toolRadius - tuning.room;
    around.along.to = fit.arm[1] + limits.toolRadius + tuning.room;
  }
  return fit;
}

}  // namespace boomwatch
