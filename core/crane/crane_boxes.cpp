#include "crane/crane_boxes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <span>

namespace boomwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t minPoints = 10;  ///< of a box

/// Columns: the principal axes of the points, the longest first; right-handed.
Matrix3d principalAxes(std::span<const Vector3d> points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p / static_cast<double>(points.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const Vector3d& p : points) spread += (p - mean) * (p - mean).transpose();
  const Matrix3d ascending = Eigen::SelfAdjointEigenSolver<Matrix3d>(spread).eigenvectors();
  Matrix3d axes;
  axes << ascending.col(2), ascending.col(1), ascending.col(2).cross(ascending.col(1));
  return axes;
}

OrientedBox boxAround(std::span<const Vector3d> points, const Matrix3d& axes) {
  Vector3d low = axes.transpose() * points.front();
  Vector3d high = low;
  for (const Vector3d& p : points) {
    low = low.cwiseMin(axes.transpose() * p);
    high = high.cwiseMax(axes.transpose() * p);
  }
  return {axes * (low + high) / 2, high - low, axes};
}

/// Cuts a boom at its bends. Sorts `points` along the boom.
void cutAtBends(std::span<Vector3d> points, std::vector<OrientedBox>& segments) {
  constexpr double maxBend = 0.4;         // metres from a straight line
  constexpr std::size_t maxSegments = 8;  // a boom has fewer; bounds the work for other clusters
  if (points.size() < minPoints || segments.size() >= maxSegments) return;
  const Matrix3d axes = principalAxes(points);
  const auto along = [&](const Vector3d& p) { return axes.col(0).dot(p); };
  std::sort(points.begin(), points.end(),
            [&](const Vector3d& a, const Vector3d& b) { return along(a) < along(b); });
  const Vector3d start = points.front();
  const Vector3d line = (points.back() - start).normalized();
  const auto off = [&](const Vector3d& p) { return line.cross(p - start).norm(); };
  const auto bend =
      std::max_element(points.begin(), points.end(),
                       [&](const Vector3d& a, const Vector3d& b) { return off(a) < off(b); });
  const auto before = static_cast<std::size_t>(bend - points.begin());
  if (!(off(*bend) > maxBend) || before < minPoints || points.size() - before < minPoints) {
    segments.push_back(boxAround(points, axes));
    return;
  }
  cutAtBends(points.first(before), segments);
  cutAtBends(points.subspan(before), segments);
}

}  // namespace

std::vector<OrientedBox> boomSegments(const Points& boom) {
  std::vector<Vector3d> points;
  for (const Eigen::Vector3f& p : boom) points.push_back(p.cast<double>());
  std::vector<OrientedBox> segments;
  cutAtBends(points, segments);
  return segments;
}

CraneBoxes craneBoxes(const Points& cluster, const Eigen::Vector3f& tool, double toolSize,
                      const std::optional<ViewedBox>& loadVolume) {
  std::vector<Vector3d> toolPoints, boomPoints;
  for (const Eigen::Vector3f& point : cluster) {
    const Vector3d p = point.cast<double>();
    if (loadVolume && loadVolume->contains(p)) continue;
    const bool isTool = (p - tool.cast<double>()).norm() <= toolSize / 2;
    (isTool ? toolPoints : boomPoints).push_back(p);
  }
  CraneBoxes boxes;
  if (!toolPoints.empty()) boxes.tool = boxAround(toolPoints, Matrix3d::Identity());
  cutAtBends(boomPoints, boxes.boom);
  const auto toTool = [&](const OrientedBox& box) {
    return (box.nearestTo(tool.cast<double>()) - tool.cast<double>()).norm();
  };
  std::sort(boxes.boom.begin(), boxes.boom.end(),
            [&](const OrientedBox& a, const OrientedBox& b) { return toTool(a) < toTool(b); });
  return boxes;
}

}  // namespace boomwatch
