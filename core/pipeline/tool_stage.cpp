#include "pipeline/tool_stage.h"

#include "pipeline/load_source.h"

namespace boomwatch {
namespace {

/// Where this frame does not show the tool, the load that it holds gives a better point than the
/// tool's own velocity: the load is seen.
ToolTrack withHeldPoint(ToolTrack tool, const std::optional<Eigen::Vector3f>& held) {
  if (!held || !tool.running() || tool.age == 0.0) return tool;
  tool.point = held;
  tool.isHeld = true;
  return tool;
}

}  // namespace

std::future<void> ToolStage::startLooking(const Frame& frame, const MatchedFrame& matched,
                                          const TrackingParameters& parameters) {
  const cv::Mat& image = matched.pair.left;
  if (frame.rig ? image.empty() : !frame.cloud) return {};
  m_tracking.offer(frame.tool, parameters.tracker);
  if (!m_tracking.needsImage()) return {};
  return std::async(std::launch::async,
                    [this, image, parameters] { m_tracking.look(image, parameters); });
}

ToolTrack ToolStage::locate(std::future<void> looking, const Frame& frame, const Cloud& cloud,
                            const std::optional<Eigen::Vector3f>& held,
                            const Parameters& parameters) {
  if (looking.valid()) looking.get();
  ToolTrack tool = m_tracking.locate(cloud, frame.stamp, parameters.tracking, held);
  const LoadSource source = loadSource(parameters.load.source, frame, tool);
  return source == LoadSource::Detected ? withHeldPoint(std::move(tool), held) : tool;
}

}  // namespace boomwatch
