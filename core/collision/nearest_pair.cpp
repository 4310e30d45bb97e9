#include "collision/nearest_pair.h"

#include <Eigen/LU>

namespace boomwatch {
namespace {

LoadPart partAt(const OrientedBox& box, const Eigen::Vector3d& p) {
  // Wide enough for the rounding of a turn there and back, narrow enough for any real box.
  constexpr double tolerance = 1e-9;
  const Eigen::Vector3d local = box.rotation.transpose() * (p - box.centre);
  const auto onFace = local.array().abs() >= box.size.array() / 2 - tolerance;
  constexpr LoadPart parts[] = {LoadPart::Inside, LoadPart::Face, LoadPart::Edge, LoadPart::Corner};
  return parts[onFace.count()];
}

}  // namespace

bool isUsable(const OrientedBox& box) {
  constexpr double farthest = 1e9;
  if (!box.centre.allFinite() || !box.size.allFinite() || !box.rotation.allFinite()) return false;
  return box.centre.cwiseAbs().maxCoeff() < farthest && box.size.maxCoeff() < farthest &&
         box.size.minCoeff() >= 0 && box.rotation.isUnitary(1e-6);
}

Nearest nearestPair(const GridGeometry& geometry, const OrientedBox& box,
                    const Eigen::Vector3d& onLoad, const Eigen::Vector3d& onEnvironment) {
  const Eigen::Vector3d halfCell = geometry.cellExtent(onEnvironment) / 2;
  const Eigen::Vector3d line = onEnvironment - onLoad;
  const double distance = line.norm();
  if (distance == 0) return {0, onLoad, onEnvironment, LoadPart::Inside, halfCell.norm()};
  const double quantisation = (line / distance).cwiseAbs().dot(halfCell);
  return {distance, onLoad, onEnvironment, partAt(box, onLoad), quantisation};
}

Clearance clearanceFrom(const std::optional<Nearest>& nearest) {
  const auto state = nearest ? ClearanceState::Measured : ClearanceState::NothingInRange;
  return {state, Reason::None, nearest, {}, {}, {}};
}

}  // namespace boomwatch
