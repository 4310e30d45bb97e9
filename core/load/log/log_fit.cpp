#include "load/log/log_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "load/log/axis_search.h"
#include "load/log/cylinder_fit.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

/// Metres.
struct Sizes {
  double length, radius;
};

/// Metres.
struct Reaches {
  CylinderLimits cylinder;
  double minArm;    ///< by which a log reaches out of the tool
  double farthest;  ///< from the tool point to the axis

  Reaches(const DepthPatch& patch, const Vector3d& tool, const LoadParameters& parameters) {
    constexpr double armCells = 4.0, thickest = 0.25;  // of the largest size, as a diameter
    constexpr double thinnest = 0.03;
    constexpr double above = 0.15;  // by which a grapple is longer than it is wide
    cylinder = {parameters.toolSize / 2.0, thinnest, thickest / 2.0 * parameters.maxSize};
    minArm = armCells * patch.cell * tool.z();
    farthest = parameters.toolSize + above;
  }
};

OrientedBox boxOf(const CylinderFit& log) {
  OrientedBox box;
  box.centre = log.centre;
  box.size = {log.length, 2.0 * log.radius, 2.0 * log.radius};
  const Vector3d view = log.centre.normalized();
  const Vector3d side = view.cross(log.axis).normalized();
  box.rotation << log.axis, side, log.axis.cross(side);
  return box;
}

/// On both sides of the tool, and seen there; a boom that passes the tool is not held by it.
bool isHeld(const CylinderFit& fit, const Reaches& reaches) {
  constexpr double minShown = 0.5, nearMiddle = 0.33;
  // The tool point lies on the tool's near side: of what points at the camera it is nearer that
  // end.
  constexpr double toolDepth = 0.2;
  const double towards = std::abs(fit.axis.dot(fit.centre.normalized()));
  const double shorter = std::min(fit.arm[0], fit.arm[1]) + reaches.cylinder.toolRadius;
  return std::min(fit.arm[0], fit.arm[1]) > reaches.minArm &&
         std::min(fit.shown[0], fit.shown[1]) > minShown * reaches.minArm &&
         shorter + toolDepth * towards > nearMiddle * fit.length;
}

bool isWhole(const CylinderFit& fit) { return fit.endSeen[0] && fit.endSeen[1]; }

/// Whether something is seen all the way from the tool point to the log: what holds it.
bool hangsTogether(const CylinderFit& fit, const DepthPatch& patch, const Vector3d& tool) {
  constexpr double deep = 0.35;  // metres by which a grapple is deeper than a line in it
  constexpr double open = 0.3;   // metres that a grapple that is seen through may show
  const Vector3d foot = fit.centre + fit.axis * fit.axis.dot(tool - fit.centre);
  const double apart = (foot - tool).norm() - fit.radius, step = patch.cell * tool.z();
  double gap = 0.0;
  for (double way = 0.0; way < apart; way += step) {
    const Vector3d p = tool + (foot - tool).normalized() * way;
    const int cell = patch.indexOf(p.x() / p.z(), p.y() / p.z());
    if (cell < 0 || std::isnan(patch.q[static_cast<std::size_t>(cell)])) continue;
    const double z = patch.point(cell).z();
    const double noise = 3.0 * patch.sigma[static_cast<std::size_t>(cell)] * p.z() * p.z();
    gap += z > p.z() + deep + noise ? step : 0.0;
  }
  return gap < open;
}

/// Whether the body goes on where the log ends, as a boom does at its joints.
bool goesOn(const CylinderFit& fit, const LoadBody& body, const DepthPatch& patch) {
  constexpr double reach = 0.4, beside = 0.2, nearest = 0.08;  // metres beyond an end, or beside it
  constexpr int stray = 8;                                     // cells
  const double towards = std::abs(fit.axis.dot(fit.centre.normalized()));
  std::array<int, 2> beyond{};
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    const Vector3d offset = body.points[i] - fit.centre;
    const double along = fit.axis.dot(offset), past = std::abs(along) - fit.length / 2.0;
    if (past < -nearest || past > reach) continue;
    const double z = body.points[i].z(), aside = (offset - along * fit.axis).norm() - fit.radius;
    const double noise = 2.0 * patch.sigma[static_cast<std::size_t>(body.cells[i])] * z * z;
    const bool isPast = past > nearest + noise * towards && aside < beside;
    const bool isAside = aside > nearest + noise && aside < reach;
    if (isPast || isAside) ++beyond[along < 0.0 ? 0 : 1];
  }
  return std::max(beyond[0], beyond[1]) > stray;
}

/// What says more: that something is there, that it is seen from end to end, or more of it.
bool saysMore(const CylinderFit& fit, const CylinderFit& than) {
  const bool found = fit.fault == LoadFault::None;
  if (found != (than.fault == LoadFault::None)) return found;
  if (!found) return than.fault == LoadFault::NoBody && fit.fault != LoadFault::NoBody;
  if (isWhole(fit) != isWhole(than)) return isWhole(fit);
  return std::min(fit.shown[0], fit.shown[1]) > std::min(than.shown[0], than.shown[1]);
}

/// How well the place of an end along the axis is known: some pixels, and the less the more it
/// points at the camera.
double endWithin(const CylinderFit& log, const DepthPatch& patch) {
  constexpr double least = 0.1, pixels = 3.0;
  const double sine = log.axis.cross(log.centre.normalized()).norm();
  return least + pixels * patch.pitch * log.centre.norm() / std::max(sine, 0.1);
}

/// Makes it as large as is known; the end that is seen stays where it is, and the other one must
/// then be where it is hidden. False where that cannot be.
bool giveSizes(CylinderFit& log, const Sizes& sizes, double within) {
  const double missing = sizes.length - log.length;
  if (isWhole(log)) {
    if (std::abs(missing) > within) return false;
  } else if (log.endSeen[0] != log.endSeen[1]) {
    const std::size_t hidden = log.endSeen[0] ? 1 : 0;
    if (missing < -within || missing > log.hidden[hidden] + within) return false;
    log.centre += log.axis * (log.endSeen[0] ? missing : -missing) / 2.0;
  } else {
    return false;
  }
  log.length = sizes.length;
  log.radius = sizes.radius;
  return true;
}

std::optional<Sizes> knownSizes(const LoadParameters& parameters,
                                const std::optional<OrientedBox>& known) {
  if (parameters.dimensions == LoadDimensions::Locked) {
    return Sizes{parameters.sizeX, std::max(parameters.sizeY, parameters.sizeZ) / 2.0};
  }
  if (!known || !isLog(*known)) return std::nullopt;
  return Sizes{known->size.x(), known->size.y() / 2.0};
}

bool isAsThick(const CylinderFit& fit, double radius) {
  constexpr double share = 0.3;
  return std::abs(fit.radius - radius) < share * radius;
}

/// followLog() where the expected pose is nearly right.
LoadDetection followFrom(const DepthPatch& patch, const Vector3d& tool,
                         const LoadParameters& parameters, const OrientedBox& expected) {
  constexpr double aside = 0.3, turned = 0.94;  // metres; cosine of 20 degrees
  constexpr double endOn = 0.12;                // radians
  const Reaches reaches(patch, tool, parameters);
  const Vector3d axis = expected.rotation.col(0);
  const Vector3d away = (expected.centre - axis * axis.dot(expected.centre)).normalized();
  const double radius = expected.size.y() / 2.0;
  const Vector3d half = axis * expected.size.x() / 2.0;
  const CylinderLimits limits{
      reaches.cylinder.toolRadius, 0.7 * radius, 1.4 * radius, endOn,
      ExpectedCylinder{expected.centre - half, expected.centre + half, radius}};
  CylinderFit log = fitCylinder(patch, tool, {expected.centre - away * radius, axis}, limits);
  if (log.fault != LoadFault::None) return LoadDetection::refused(log.fault);
  const Vector3d offset = expected.centre - log.centre;
  const double across = (offset - log.axis * log.axis.dot(offset)).norm();
  const Vector3d toTool = tool - log.centre;
  if (std::abs(log.axis.dot(axis)) < turned || across > aside ||
      (toTool - log.axis * log.axis.dot(toTool)).norm() > reaches.farthest ||
      !isAsThick(log, radius) || std::max(log.shown[0], log.shown[1]) < reaches.minArm) {
    return LoadDetection::refused(LoadFault::NoBody);
  }
  // An arm that is hidden altogether does not end at the tool.
  for (const std::size_t side : {0U, 1U})
    log.endSeen[side] = log.endSeen[side] && log.shown[side] > 0.0;
  const bool whole = isWhole(log);
  const Sizes sizes{expected.size.x(), radius};
  const bool isLocked = parameters.dimensions == LoadDimensions::Locked;
  const double within = endWithin(log, patch);
  if (whole && !isLocked && std::abs(log.length - sizes.length) < within) {
    return {boxOf(log), LoadFault::None, isHeld(log, reaches)};
  }
  if (!giveSizes(log, sizes, within)) return LoadDetection::refused(LoadFault::EndHidden);
  return {boxOf(log), LoadFault::None, false};
}

}  // namespace

bool isLog(const OrientedBox& box) {
  return std::abs(box.size.y() - box.size.z()) < 0.01 * box.size.y() &&
         box.size.x() > 1.5 * box.size.y();
}

LoadDetection findLog(const DepthPatch& patch, const LoadBody& body,
                      const LoadParameters& parameters, const std::optional<OrientedBox>& known) {
  constexpr int maxTried = 7;
  const Reaches reaches(patch, body.tool, parameters);
  AxisSearch search(patch, body, {reaches.cylinder.toolRadius, reaches.minArm, reaches.farthest});
  CylinderFit log;
  log.fault = LoadFault::NoBody;
  for (int k = 0; k < maxTried && !(log.fault == LoadFault::None && isWhole(log)); ++k) {
    const auto axis = search.next();
    if (!axis) break;
    CylinderFit fit = fitCylinder(patch, body.tool, *axis, reaches.cylinder);
    const bool isThere = fit.fault == LoadFault::None;
    if (isThere && (!isHeld(fit, reaches) || !hangsTogether(fit, patch, body.tool) ||
                    goesOn(fit, body, patch))) {
      fit.fault = LoadFault::NoBody;
    }
    if (saysMore(fit, log)) log = fit;
    if (isThere) search.leaveOut(fit.centre, fit.axis, fit.length / 2.0, fit.radius);
  }
  if (log.fault != LoadFault::None) return LoadDetection::refused(log.fault);
  const auto sizes = knownSizes(parameters, known);
  const bool isLocked = parameters.dimensions == LoadDimensions::Locked, whole = isWhole(log);
  if (isLocked || !whole) {
    const bool fits = sizes && (isLocked || isAsThick(log, sizes->radius));
    if (!fits || !giveSizes(log, *sizes, endWithin(log, patch)))
      return LoadDetection::refused(LoadFault::EndHidden);
  }
  return {boxOf(log), LoadFault::None, whole};
}

LoadDetection followLog(const DepthPatch& patch, const Vector3d& tool,
                        const LoadParameters& parameters, const OrientedBox& expected) {
  // How far it has turned since towards the camera, or away: of its pose that is seen least.
  // Radians.
  constexpr std::array turns{0.0, 0.08, -0.08, 0.16, -0.16};
  const Vector3d across = expected.centre.cross(expected.rotation.col(0));
  LoadDetection untilted = LoadDetection::refused(LoadFault::EndOn);
  if (!(across.norm() > 0.0)) return untilted;
  for (const double turn : turns) {
    OrientedBox tried = expected;
    tried.rotation =
        Eigen::AngleAxisd(turn, across.normalized()).toRotationMatrix() * expected.rotation;
    const LoadDetection found = followFrom(patch, tool, parameters, tried);
    if (found.box) return found;
    if (turn == 0.0) untilted = found;
  }
  return untilted;
}

}  // namespace boomwatch
