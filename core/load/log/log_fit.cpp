#include "load/log/log_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "load/log/axis_search.h"
#include "load/log/cylinder_fit.h"
#include "load/log/log_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr LogTuning::Find tuning;
constexpr LogTuning::Follow follow;

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
    cylinder = {parameters.toolSize / 2.0, tuning.thinnest,
                tuning.thickest / 2.0 * parameters.maxSize};
    minArm = tuning.armCells * patch.cell * tool.z();
    farthest = parameters.toolSize + tuning.above;
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
  // The tool point lies on the tool's near side: of what points at the camera it is nearer that
  // end.
  const double towards = std::abs(fit.axis.dot(fit.centre.normalized()));
  const double shorter = std::min(fit.arm[0], fit.arm[1]) + reaches.cylinder.toolRadius;
  return std::min(fit.arm[0], fit.arm[1]) > reaches.minArm &&
         std::min(fit.shown[0], fit.shown[1]) > tuning.minShown * reaches.minArm &&
         shorter + tuning.toolDepth * towards > tuning.nearMiddle * fit.length;
}

bool isWhole(const CylinderFit& fit) { return fit.endSeen[0] && fit.endSeen[1]; }

/// Whether something is seen all the way from the tool point to the log: what holds it.
bool hangsTogether(const CylinderFit& fit, const DepthPatch& patch, const Vector3d& tool) {
  const Vector3d foot = fit.centre + fit.axis * fit.axis.dot(tool - fit.centre);
  const double apart = (foot - tool).norm() - fit.radius, step = patch.cell * tool.z();
  double gap = 0.0;
  for (double way = 0.0; way < apart; way += step) {
    const Vector3d p = tool + (foot - tool).normalized() * way;
    const int cell = patch.indexOf(p.x() / p.z(), p.y() / p.z());
    if (cell < 0 || std::isnan(patch.q[static_cast<std::size_t>(cell)])) continue;
    const double z = patch.point(cell).z();
    const double noise = 3.0 * patch.sigma[static_cast<std::size_t>(cell)] * p.z() * p.z();
    gap += z > p.z() + tuning.deep + noise ? step : 0.0;
  }
  return gap < tuning.open;
}

/// Whether the body goes on where the log ends, as a boom does at its joints.
bool goesOn(const CylinderFit& fit, const LoadBody& body, const DepthPatch& patch) {
  const double towards = std::abs(fit.axis.dot(fit.centre.normalized()));
  std::array<int, 2> beyond{};
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    const Vector3d offset = body.points[i] - fit.centre;
    const double along = fit.axis.dot(offset), past = std::abs(along) - fit.length / 2.0;
    if (past < -tuning.onNearest || past > tuning.onwards) continue;
    const double z = body.points[i].z(), aside = (offset - along * fit.axis).norm() - fit.radius;
    const double noise = 2.0 * patch.sigma[static_cast<std::size_t>(body.cells[i])] * z * z;
    const bool isPast = past > tuning.onNearest + noise * towards && aside < tuning.onBeside;
    const bool isAside = aside > tuning.onNearest + noise && aside < tuning.onwards;
    if (isPast || isAside) ++beyond[along < 0.0 ? 0 : 1];
  }
  return std::max(beyond[0], beyond[1]) > tuning.stray;
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
  const double sine = log.axis.cross(log.centre.normalized()).norm();
  return tuning.endWithin +
         tuning.endPitches * patch.pitch * log.centre.norm() / std::max(sine, tuning.minSine);
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
  return std::abs(fit.radius - radius) < tuning.thickShare * radius;
}

/// followLog() where the expected pose is nearly right.
LoadDetection followFrom(const DepthPatch& patch, const Vector3d& tool,
                         const LoadParameters& parameters, const OrientedBox& expected) {
  const Reaches reaches(patch, tool, parameters);
  const Vector3d axis = expected.rotation.col(0);
  const Vector3d away = (expected.centre - axis * axis.dot(expected.centre)).normalized();
  const double radius = expected.size.y() / 2.0;
  const Vector3d half = axis * expected.size.x() / 2.0;
  const CylinderLimits limits{
      reaches.cylinder.toolRadius, follow.thinner * radius, follow.thicker * radius, follow.endOn,
      ExpectedCylinder{expected.centre - half, expected.centre + half, radius}};
  CylinderFit log = fitCylinder(patch, tool, {expected.centre - away * radius, axis}, limits);
  if (log.fault != LoadFault::None) return LoadDetection::refused(log.fault);
  const Vector3d offset = expected.centre - log.centre;
  const double across = (offset - log.axis * log.axis.dot(offset)).norm();
  const Vector3d toTool = tool - log.centre;
  if (std::abs(log.axis.dot(axis)) < follow.turned || across > follow.aside ||
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
         box.size.x() > tuning.logAspect * box.size.y();
}

LoadDetection findLog(const DepthPatch& patch, const LoadBody& body,
                      const LoadParameters& parameters, const std::optional<OrientedBox>& known) {
  const Reaches reaches(patch, body.tool, parameters);
  AxisSearch search(patch, body, {reaches.cylinder.toolRadius, reaches.minArm, reaches.farthest});
  CylinderFit log;
  log.fault = LoadFault::NoBody;
  for (int k = 0; k < tuning.maxTried && !(log.fault == LoadFault::None && isWhole(log)); ++k) {
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
  const Vector3d across = expected.centre.cross(expected.rotation.col(0));
  LoadDetection untilted = LoadDetection::refused(LoadFault::EndOn);
  if (!(across.norm() > 0.0)) return untilted;
  for (const double turn : follow.tilts) {
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
