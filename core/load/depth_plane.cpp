#include "load/depth_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "load/load_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr LoadTuning::Plane tuning;

std::optional<DepthPlane> planeThrough(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  const double distance = normal.dot(a);
  if (normal.norm() < 1e-9 || std::abs(distance) < 1e-6 * normal.norm()) return std::nullopt;
  return DepthPlane{normal / distance};
}

/// Least squares in q over the cells that `plane` holds.
DepthPlane refined(const DepthPlane& plane, const DepthPatch& patch, const std::vector<int>& cells,
                   double thickness) {
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity() * 1e-9;
  Vector3d right = Vector3d::Zero();
  for (const int cell : cells) {
    if (!plane.holds(patch, cell, thickness)) continue;
    const Vector3d direction = patch.point(cell) * patch.q[static_cast<std::size_t>(cell)];
    left += direction * direction.transpose();
    right += direction * static_cast<double>(patch.q[static_cast<std::size_t>(cell)]);
  }
  return {left.ldlt().solve(right)};
}

}  // namespace

std::optional<DepthPlane> dominantPlane(const DepthPatch& patch, const std::vector<int>& cells,
                                        double thickness) {
  std::minstd_rand random(1);
  std::uniform_int_distribution<std::size_t> pick(0, cells.size() - 1);
  std::vector<int> sample(std::min(tuning.looked, cells.size()));
  for (int& cell : sample) cell = cells[pick(random)];
  std::optional<DepthPlane> best;
  std::ptrdiff_t most = 0;
  for (int k = 0; k < tuning.hypotheses; ++k) {
    const auto plane =
        planeThrough(patch.point(cells[pick(random)]), patch.point(cells[pick(random)]),
                     patch.point(cells[pick(random)]));
    if (!plane) continue;
    const auto held = std::count_if(sample.begin(), sample.end(),
                                    [&](int cell) { return plane->holds(patch, cell, thickness); });
    if (held > most) most = held, best = plane;
  }
  if (!best) return std::nullopt;
  return refined(refined(*best, patch, cells, thickness), patch, cells, thickness);
}

}  // namespace boomwatch
