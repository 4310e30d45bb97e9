#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>

#include "simulation/yard/yard_source.h"
#include "tracking/tool_tracking.h"

namespace boomwatch {

/// A tracker that is told where the tool is: what is left of a chain's errors is not the tracker's.
class TrueTool {
 public:
  TrueTool() : m_box(std::make_shared<std::optional<cv::Rect2d>>()) {}

  /// For a Pipeline; gives trackers that say what was last set.
  TrackerMaker maker() const;
  /// What makes the pipeline begin to track.
  static ToolOrder order() { return TrackBox{cv::Rect2d(0, 0, 8, 8)}; }
  /// The tool's box in the next picture; absent: it is not seen.
  void set(const std::optional<cv::Rect2d>& box) { *m_box = box; }

 private:
  std::shared_ptr<std::optional<cv::Rect2d>> m_box;
};

/// The part of the tool's box (Frame::tool) inside the picture, of a frame of demo:yard, where at
/// least `share` of the tool is seen and the box is large enough to be followed.
std::optional<cv::Rect2d> toolBoxIn(const YardFrame& shown, double share);

}  // namespace boomwatch
