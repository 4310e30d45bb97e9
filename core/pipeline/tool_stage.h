#pragma once

#include <Eigen/Core>
#include <future>
#include <optional>

#include "frame/frame.h"
#include "parameters/parameters.h"
#include "pipeline/sensing_stage.h"
#include "tracking/tool_tracking.h"

namespace boomwatch {

/// Owns the tracker, and runs it in a thread of its own while the pipeline works on the cloud. A
/// frame is one startLooking() and one locate(). Used by one thread.
class ToolStage {
 public:
  explicit ToolStage(const TrackerMaker& maker) : m_tracking(maker) {}

  /// Takes effect with the next frame that has a picture.
  void order(const ToolOrder& order) { m_tracking.order(order); }

  /// Starts the tracker on the frame's picture, also where the matching failed: the tool goes on
  /// all the same. The future is not valid where there is no picture, or no tracker to run.
  /// Destroying it waits for the tracker.
  [[nodiscard]] std::future<void> startLooking(const Frame& frame, const MatchedFrame& matched,
                                               const TrackingParameters& parameters);

  /// Waits for `looking`, then looks up the tool's point in `cloud` (camera frame, metres). `held`:
  /// where the tool must be by the load that it holds, see HeldTool; absent if that is not known.
  ToolTrack locate(std::future<void> looking, const Frame& frame, const Cloud& cloud,
                   const std::optional<Eigen::Vector3f>& held, const Parameters& parameters);

 private:
  ToolTracking m_tracking;
};

}  // namespace boomwatch
