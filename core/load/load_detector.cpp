#include "load/load_detector.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "load/box_fit.h"
#include "load/load_tuning.h"
#include "load/log/log_fit.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

LoadDetection judged(const LoadDetection& found, const Bounds& bounds, double maxSize) {
  if (!found.box) return found;
  if (!(found.box->size.maxCoeff() <= maxSize)) return LoadDetection::refused(LoadFault::TooLarge);
  if (!bounds.contains(found.box->centre.cast<float>())) {
    return LoadDetection::refused(LoadFault::OutsideBounds);
  }
  return found;
}

}  // namespace

ViewedBox dynamicVolume(const OrientedBox& load, double margin, double depthNoise, double smear) {
  const double noise = LoadTuning::deviations * depthNoise;
  ViewedBox volume(load, noise, std::max(noise, smear));
  volume.box.size += 2.0 * Vector3d::Constant(margin);
  return volume;
}

LoadDetection detectLoad(const Cloud& cloud, const Eigen::Vector3f& tool, double depthNoise,
                         const Bounds& bounds, const LoadParameters& parameters,
                         const std::optional<OrientedBox>& expected) {
  const double reach = LoadTuning::Detector().reachShare * parameters.maxSize;
  // A log is measured by its outline, a box by the cells themselves.
  constexpr LoadTuning::Patch patchTuning;
  const double samplesPerCell =
      parameters.shape == LoadShape::Cylinder ? patchTuning.logSamples : patchTuning.boxSamples;
  const DepthPatch patch = patchAround(cloud, tool, reach, depthNoise, samplesPerCell);
  if (patch.empty()) return LoadDetection::refused(LoadFault::NothingAtTool);
  if (expected && isLog(*expected) && parameters.shape != LoadShape::Box) {
    const LoadDetection same = followLog(patch, tool.cast<double>(), parameters, *expected);
    if (same.box) return judged(same, bounds, parameters.maxSize);
  }
  const LoadBody body = growBody(patch, tool, {reach, parameters.toolSize / 2.0, bounds});
  if (body.fault != LoadFault::None) return LoadDetection::refused(body.fault);
  LoadDetection found = LoadDetection::refused(LoadFault::NoBody);
  if (parameters.shape != LoadShape::Box) found = findLog(patch, body, parameters, expected);
  const bool none = found.fault == LoadFault::NoBody || found.fault == LoadFault::PoorFit;
  if (parameters.shape == LoadShape::Box || (parameters.shape == LoadShape::Auto && none)) {
    found = fitBox(patch, body, reach, parameters);
  }
  return judged(found, bounds, parameters.maxSize);
}

}  // namespace boomwatch
