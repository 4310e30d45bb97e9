#include "crane/beam.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>
#include <vector>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr std::size_t minPoints = 10, maxPoints = 400;  ///< used for the fit

struct Line {
  Vector3d point, axis;
  bool holds(const Vector3d& p, double radius) const {
    return axis.cross(p - point).squaredNorm() <= radius * radius;
  }
};

Line maxHeld(const std::vector<Vector3d>& points, double radius) {
  constexpr int tries = 150;
  std::mt19937 random(1);
  Line best{points.front(), Vector3d::UnitX()};
  std::ptrdiff_t most = -1;
  for (int i = 0; i < tries; ++i) {
    const Vector3d& a = points[random() % points.size()];
    const Vector3d way = points[random() % points.size()] - a;
    if (way.norm() < 2 * radius) continue;
    const Line line{a, way.normalized()};
    const auto held =
        std::ranges::count_if(points, [&](const Vector3d& p) { return line.holds(p, radius); });
    if (held > most) most = held, best = line;
  }
  return best;
}

Line through(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points) spread += (p - mean) * (p - mean).transpose();
  return {mean, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2)};
}

std::vector<Vector3d> heldBy(const Line& line, const std::vector<Vector3d>& points, double radius) {
  std::vector<Vector3d> held;
  std::ranges::copy_if(points, std::back_inserter(held),
                       [&](const Vector3d& p) { return line.holds(p, radius); });
  return held;
}

}  // namespace

std::optional<Beam> beamIn(const Points& points, double radius) {
  constexpr double stray = 0.02;    // share of points cut off at either end, as outliers
  constexpr double slender = 1.25;  // minimum of length to width
  const std::size_t step = std::max<std::size_t>(1, points.size() / maxPoints);
  std::vector<Vector3d> some;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i].cast<double>());
  if (some.size() < minPoints) return std::nullopt;
  Line line = maxHeld(some, radius);
  std::vector<Vector3d> held;
  for (int pass = 0; pass < 2; ++pass) {
    held = heldBy(line, some, radius);
    if (held.size() < minPoints) return std::nullopt;
    line = through(held);
  }
  std::vector<double> along;
  for (const Vector3d& p : held) along.push_back(line.axis.dot(p - line.point));
  std::ranges::sort(along);
  const auto cut = static_cast<std::size_t>(stray * static_cast<double>(along.size()));
  const double low = along[cut], high = along[along.size() - 1 - cut];
  if (high - low < slender * 2 * radius) return std::nullopt;
  return Beam{line.point + (low + high) / 2 * line.axis, line.axis, high - low,
              static_cast<double>(held.size()) / static_cast<double>(some.size())};
}

}  // namespace boomwatch
