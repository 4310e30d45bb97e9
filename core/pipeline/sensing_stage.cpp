#include "pipeline/sensing_stage.h"

#include "base/error.h"
#include "cloud/depth_noise.h"

namespace boomwatch {
namespace {

/// Pixels of disparity: at a near object's rim the matcher's block holds background as well.
constexpr double matcherSmear = 2.0;

}  // namespace

double inverseDepthSmear(const SensedFrame& sensed) {
  return matcherSmear * sensed.whole->noise.perPixel;
}

std::optional<double> depthUncertainty(const SensedFrame& sensed, double z) {
  const DepthNoise& noise = sensed.whole->noise;
  if (noise.perPixel == 0.0) return std::nullopt;
  return noise.at(z);
}

MatchedFrame SensingStage::match(const Frame& frame, const StereoParameters& parameters) {
  MatchedFrame matched;
  if (!frame.rig) {
    matched.pair.left = frame.left;
    if (!frame.cloud) matched.fault = "The frame holds neither a cloud nor a stereo pair.";
    return matched;
  }
  try {
    matched.pair = m_stereo.rectify(frame.left, frame.right, *frame.rig, parameters);
    matched.disparity = matchDisparity(matched.pair.left, matched.pair.right, parameters);
  } catch (const Error& fault) {
    matched.fault = fault.what();
  }
  return matched;
}

SensedFrame SensingStage::reproject(const Frame& frame, const MatchedFrame& matched,
                                    const Parameters& parameters) {
  SensedFrame sensed;
  sensed.image = matched.pair.left;
  sensed.fault = matched.fault;
  if (!sensed.fault.empty()) return sensed;
  if (!frame.rig) {
    sensed.whole = sensed.cloud = withoutDepthNoise(frame.cloud, parameters.filter.depthSmooth);
    return sensed;
  }
  try {
    const StereoResult stereo =
        m_stereo.reconstruct(matched.pair, matched.disparity, parameters.stereo);
    sensed.cloud = stereo.surfaces;
    sensed.whole = stereo.cloud;
    sensed.rowResidue = stereo.rowResidue;
    sensed.rowsCorrected = stereo.rowsCorrected;
  } catch (const Error& fault) {
    sensed.fault = fault.what();
  }
  return sensed;
}

}  // namespace boomwatch
