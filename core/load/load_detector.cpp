#include "load/load_detector.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "load/axis_search.h"
#include "load/box_fit.h"
#include "load/cylinder_fit.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

/// Of the largest load: how far from the tool its parts may be, where it is not held in the middle.
constexpr double reachShare = 0.6;

LoadDetection judged(const OrientedBox& box, const Bounds& bounds, double maxSize) {
  if (!(box.size.maxCoeff() <= maxSize)) return LoadDetection::refused(LoadFault::TooLarge);
  if (!bounds.contains(box.centre.cast<float>())) {
    return LoadDetection::refused(LoadFault::OutsideBounds);
  }
  return {box, LoadFault::None};
}

OrientedBox boxOf(const CylinderFit& log) {
  OrientedBox box;
  box.centre = log.centre;
  box.size = {log.length, 2.0 * log.radius, 2.0 * log.radius};
  const Vector3d view = log.centre.normalized();
  const Vector3d side = view.cross(log.axis).normalized();
  box.rotation << log.axis, side, log.axis.cross(side);
  return box;
}

/// Keeps the end that is seen where it is.
void lockSizes(CylinderFit& log, const LoadParameters& parameters) {
  const double missing = parameters.sizeX - log.length;
  if (log.endSeen[0] != log.endSeen[1]) {
    log.centre += log.axis * (log.endSeen[0] ? missing : -missing) / 2.0;
  }
  log.length = parameters.sizeX;
  log.radius = std::max(parameters.sizeY, parameters.sizeZ) / 2.0;
}

/// On both sides of the tool, and seen there.
bool isHeld(const CylinderFit& fit, double leastArm) {
  constexpr double leastShown = 0.5;
  return std::min(fit.arm[0], fit.arm[1]) > leastArm &&
         std::min(fit.shown[0], fit.shown[1]) > leastShown * leastArm;
}

LoadDetection detectLog(const DepthPatch& patch, const LoadBody& body, const Bounds& bounds,
                        const LoadParameters& parameters) {
  constexpr double armCells = 4.0, thickest = 0.25;  // of the largest size, as a diameter
  constexpr double above = 0.15;  // metres by which a grapple is longer than it is wide
  const double leastArm = armCells * patch.cell * body.tool.z(), toolRadius = parameters.toolSize / 2;
  const CylinderLimits limits{toolRadius, thickest / 2.0 * parameters.maxSize};
  CylinderFit log;
  log.fault = LoadFault::NoBody;
  for (const LoadAxis& axis :
       findAxes(patch, body, {toolRadius, leastArm, parameters.toolSize + above})) {
    CylinderFit fit = fitCylinder(patch, body.tool, axis, limits);
    if (fit.fault == LoadFault::None && !isHeld(fit, leastArm)) fit.fault = LoadFault::NoBody;
    const double shown = fit.shown[0] + fit.shown[1], before = log.shown[0] + log.shown[1];
    const bool better = log.fault != LoadFault::None || shown > before;
    // What says more than that there is nothing is kept.
    if (fit.fault == LoadFault::None ? better : log.fault == LoadFault::NoBody) log = fit;
  }
  if (log.fault != LoadFault::None) return LoadDetection::refused(log.fault);
  const bool locked = parameters.dimensions == LoadDimensions::Locked;
  if (!(log.endSeen[0] && log.endSeen[1]) && !(locked && (log.endSeen[0] || log.endSeen[1]))) {
    return LoadDetection::refused(LoadFault::EndHidden);
  }
  if (locked) lockSizes(log, parameters);
  return judged(boxOf(log), bounds, parameters.maxSize);
}

}  // namespace

OrientedBox dynamicVolume(const OrientedBox& load, double margin, double depthNoise) {
  constexpr double deviations = 3.0;
  OrientedBox volume = load;
  const double z2 = load.centre.z() * load.centre.z();
  const Vector3d sight = (load.rotation.transpose() * load.centre.normalized()).cwiseAbs();
  volume.size += 2.0 * (Vector3d::Constant(margin) + deviations * depthNoise * z2 * sight);
  return volume;
}

LoadDetection detectLoad(const Cloud& cloud, const Eigen::Vector3f& tool, double depthNoise,
                         const Bounds& bounds, const LoadParameters& parameters) {
  const double reach = reachShare * parameters.maxSize;
  const DepthPatch patch = patchAround(cloud, tool, reach, depthNoise);
  if (patch.empty()) return LoadDetection::refused(LoadFault::NothingAtTool);
  const LoadBody body = growBody(patch, tool, {reach, parameters.toolSize / 2.0, bounds});
  if (body.fault != LoadFault::None) return LoadDetection::refused(body.fault);
  LoadDetection found = LoadDetection::refused(LoadFault::NoBody);
  if (parameters.shape != LoadShape::Box) found = detectLog(patch, body, bounds, parameters);
  const bool none = found.fault == LoadFault::NoBody || found.fault == LoadFault::PoorFit;
  if (parameters.shape == LoadShape::Box || (parameters.shape == LoadShape::Auto && none)) {
    const LoadDetection box = fitBox(patch, body, reach, parameters);
    found = box.box ? judged(*box.box, bounds, parameters.maxSize) : box;
  }
  return found;
}

}  // namespace boomwatch
