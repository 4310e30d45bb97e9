#include "lab/experiments/masked_chain.h"

#include <algorithm>

#include "cloud/depth_noise.h"
#include "simulation/yard/yard_truth.h"

namespace boomwatch {
namespace {

bool isCrane(YardKind kind) {
  return kind == YardKind::Crane || kind == YardKind::Tool || kind == YardKind::Load;
}

StaticScene withoutCrane(const Frame& frame, const Parameters& parameters) {
  const cv::Mat& kinds = frame.truth->yard->kind;
  Cloud rest = *withoutDepthNoise(frame.cloud, parameters.filter.depthSmooth);
  Points crane;
  for (int v = 0; v < kinds.rows; ++v) {
    for (int u = 0; u < kinds.cols; ++u) {
      if (!isCrane(YardKind{kinds.at<std::uint8_t>(v, u)})) continue;
      const auto k = static_cast<std::size_t>(v) * static_cast<std::size_t>(kinds.cols) +
                     static_cast<std::size_t>(u);
      if (parameters.bounds.contains(rest.points[k])) crane.push_back(rest.points[k]);
      rest.points[k] = unmeasuredPoint();
    }
  }
  StaticScene scene = separateStatic(rest, std::nullopt, std::nullopt, parameters);
  scene.removed = std::move(crane);
  return scene;
}

}  // namespace

MaskedChain::Outcome MaskedChain::process(const Frame& frame, const Parameters& parameters) {
  m_environment.learn(*frame.cloud, withoutCrane(frame, parameters), parameters);
  Outcome outcome;
  outcome.clearance = m_environment.around(*frame.load, parameters);
  m_warning = nextWarning(
      m_warning,
      {frame.stamp, outcome.clearance, approach(frame, outcome.clearance, parameters.warning)},
      parameters.warning);
  outcome.level = m_warning.level;
  return outcome;
}

std::optional<Approach> MaskedChain::approach(const Frame& frame, const Clearance& clearance,
                                              const WarningParameters& limits) {
  const auto velocity = m_motion.update(frame.stamp, frame.load->centre);
  if (!velocity || clearance.state == ClearanceState::Unknown) return std::nullopt;
  Approach approach;
  approach.velocity = *velocity;
  if (const auto& nearest = clearance.nearest; nearest && nearest->distance > 0.0) {
    approach.closingSpeed =
        velocity->dot(nearest->onEnvironment - nearest->onLoad) / nearest->distance;
  }
  approach.timeToContact = timeToContact(m_environment.exact(), *frame.load, *velocity,
                                         std::max(limits.cautionTime, limits.warningTime));
  return approach;
}

}  // namespace boomwatch
