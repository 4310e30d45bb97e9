#include "lab/experiments/masked_chain.h"

#include "cloud/depth_noise.h"
#include "simulation/yard/yard_truth.h"

namespace boomwatch {
namespace {

bool isCrane(YardKind kind) {
  return kind == YardKind::Crane || kind == YardKind::Tool || kind == YardKind::Load;
}

StaticScene withoutCrane(const Frame& frame, const YardTruth& truth, const Parameters& parameters) {
  const cv::Mat& kinds = truth.kind;
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

MaskedChain::Outcome MaskedChain::process(const Frame& frame, const YardTruth& truth,
                                          const Parameters& parameters) {
  m_environment.update(*frame.cloud, withoutCrane(frame, truth, parameters), parameters);
  Outcome outcome;
  outcome.clearance = m_environment.clearanceOf(*frame.load, parameters);
  outcome.level = m_warning
                      .update({frame.stamp, frame.load, outcome.clearance}, m_environment.exact(),
                              parameters.warning)
                      .level;
  return outcome;
}

}  // namespace boomwatch
