#include "lab/experiments/chain_stage.h"

#include <array>
#include <cmath>
#include <limits>

#include "frame/stereo_rig.h"
#include "simulation/demo_camera.h"
#include "simulation/yard/depth_cloud.h"
#include "simulation/yard/yard_sensor.h"
#include "tracking/make_tracker.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr double depthNoise = 0.2;  // pixels of disparity, as demo:yard,as=depth has by default
constexpr double seenShare = 0.25;  // of the tool: the least that a tracker could follow

bool hasItsPlace(YardKind kind) { return kind != YardKind::Nothing && !moves(kind); }

/// How much of what is seen lies how far from the load.
class SeenArea {
  static constexpr std::size_t bins = 400;
  static constexpr double width = 0.01;  // metres

 public:
  static constexpr double range = bins * width;  ///< metres; what is farther is not counted

  void add(double distance, double area) {
    const double bin = distance / width;
    if (bin < bins) m_areas[static_cast<std::size_t>(bin)] += area;
  }
  /// Metres within which there is as much as `area`, square metres.
  std::optional<double> within(double area) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < bins; ++k) {
      sum += m_areas[k];
      if (sum >= area) return static_cast<double>(k + 1) * width;
    }
    return std::nullopt;
  }

 private:
  std::array<double, bins> m_areas{};
};

/// The nearest of the static surfaces that the camera sees.
void lookAround(const YardFrame& shown, ChainFrame& truth) {
  const YardTruth& yard = *shown.truth;
  SeenArea area;
  double nearest = std::numeric_limits<double>::infinity();
  const double loadRadius = 0.5 * yard.load.size.norm();
  for (int v = 0; v < yard.depth.rows; ++v) {
    const auto* depth = yard.depth.ptr<float>(v);
    const auto* kind = yard.kind.ptr<std::uint8_t>(v);
    for (int u = 0; u < yard.depth.cols; ++u) {
      if (!hasItsPlace(YardKind{kind[u]}) || !std::isfinite(depth[u])) continue;
      const Vector3d p = double{depth[u]} * demoCamera.ray(u, v);
      const double least = (p - yard.load.centre).norm() - loadRadius;
      if (least >= std::max(nearest, SeenArea::range)) continue;  // changes neither
      const double distance = (yard.load.nearestTo(p) - p).norm();
      const double pixel = double{depth[u]} / demoCamera.fx;
      area.add(distance, pixel * pixel);
      if (distance >= nearest) continue;
      nearest = distance;
      truth.seenKind = YardKind{kind[u]};
    }
  }
  if (std::isfinite(nearest)) truth.seen = nearest;
  truth.patch = area.within(minPatch * minPatch);
}

/// What stands where the chain has its nearest point.
YardKind kindAt(const YardFrame& shown, const Vector3d& p) {
  constexpr double close = 0.2;  // metres
  const YardTruth& yard = *shown.truth;
  if (p.z() < 0.1) return YardKind::Nothing;
  const Eigen::Vector2d pixel = demoCamera.project(p);
  const int u0 = static_cast<int>(std::lround(pixel.x()));
  const int v0 = static_cast<int>(std::lround(pixel.y()));
  const int reach = static_cast<int>(std::ceil(close * demoCamera.fx / p.z()));
  const cv::Rect around = cv::Rect(u0 - reach, v0 - reach, 2 * reach + 1, 2 * reach + 1) &
                          cv::Rect({0, 0}, yard.depth.size());
  double nearest = close;
  YardKind kind = YardKind::Nothing;
  for (int v = around.y; v < around.br().y; ++v) {
    for (int u = around.x; u < around.br().x; ++u) {
      const auto z = static_cast<double>(yard.depth.at<float>(v, u));
      if (!std::isfinite(z)) continue;
      const double distance = (z * demoCamera.ray(u, v) - p).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      kind = YardKind{yard.kind.at<std::uint8_t>(v, u)};
    }
  }
  return kind;
}

std::optional<double> lesser(const std::optional<YardApproach>& a,
                             const std::optional<YardApproach>& b) {
  if (!a && !b) return std::nullopt;
  if (!a || !b) return (a ? a : b)->pair.distance;
  return std::min(a->pair.distance, b->pair.distance);
}

Parameters parametersOf(ChainKind kind, Parameters parameters) {
  parameters.load.source = kind == ChainKind::Everything ? LoadSource::Detected : LoadSource::Scene;
  return parameters;
}

}  // namespace

std::string_view nameOf(ChainKind kind) {
  switch (kind) {
    case ChainKind::MaskedCloud:
      return "exact mask, exact points";
    case ChainKind::MaskedDepth:
      return "exact mask, noisy depth";
    case ChainKind::TruthCloud:
      return "truth cloud";
    case ChainKind::NoisyDepth:
      return "noisy depth";
    case ChainKind::Stereo:
      return "stereo";
    case ChainKind::Everything:
      return "stereo + tracker + detector";
  }
  return "";
}

ChainFrame truthOf(const YardFrame& shown, const YardFrame& before) {
  const Frame& frame = *shown.frame;
  const YardTruth& yard = *shown.truth;
  ChainFrame truth;
  truth.stamp = frame.stamp;
  truth.truth = *frame.trueDistance;
  truth.truthKind = yard.nearest.kind;
  truth.moving = lesser(yard.person, yard.branch);
  if (before.frame && frame.stamp > before.frame->stamp) {
    truth.speed =
        (yard.load.centre - before.truth->load.centre).norm() / (frame.stamp - before.frame->stamp);
  }
  lookAround(shown, truth);
  return truth;
}

ChainStage::ChainStage(ChainKind kind, const Parameters& parameters, std::uint64_t seed)
    : m_kind(kind),
      m_parameters(parametersOf(kind, parameters)),
      m_seed(seed),
      m_pipeline(kind == ChainKind::Everything ? TrackerMaker(makeTracker) : m_tool.maker()) {}

FramePtr ChainStage::sensed(const YardFrame& shown) const {
  if (m_kind == ChainKind::Stereo || m_kind == ChainKind::Everything) return shown.frame;
  auto made = std::make_shared<Frame>(*shown.frame);
  const YardTruth& yard = *shown.truth;
  cv::Mat depth = yard.depth.clone();
  if (m_kind == ChainKind::NoisyDepth || m_kind == ChainKind::MaskedDepth) {
    addDepthNoise(depth, depthNoise, yard.depthTimesDisparity,
                  depthNoiseStream(m_seed, made->sequence));
    roundToMillimetres(depth);
  }
  made->cloud = cloudOf(depth, demoCamera);
  made->right.release();
  made->rig.reset();
  return made;
}

/// Everything is left to the chain itself: it begins with the box that the source offers.
void ChainStage::showTool(const YardFrame& shown) {
  if (m_kind == ChainKind::Everything) return;
  m_tool.set(toolBoxIn(shown, seenShare));
  if (!m_begun) m_pipeline.order(TrueTool::order());
  m_begun = true;
}

MaskedChain::Outcome ChainStage::look(const YardFrame& shown) {
  if (isMasked()) return m_masked.process(*sensed(shown), *shown.truth, m_parameters);
  showTool(shown);
  const Result result = m_pipeline.process(sensed(shown), m_parameters);
  return {result.clearance, result.level};
}

void ChainStage::process(const YardFrame& shown, const ChainFrame& truth) {
  const MaskedChain::Outcome outcome = look(shown);
  ChainFrame seen = truth;
  seen.level = outcome.level;
  seen.reason = outcome.clearance.reason;
  if (const auto& nearest = outcome.clearance.nearest) {
    seen.reported = nearest->distance;
    seen.blamed = kindAt(shown, nearest->onEnvironment);
  }
  m_frames.push_back(seen);
}

}  // namespace boomwatch
