#pragma once

#include <Eigen/Core>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "tracking/tracker.h"

namespace boomwatch {

/// The tool as one frame shows it. What is not known is absent.
struct ToolTrack {
  TrackState state = TrackState::Idle;  ///< Idle: no tracker runs; the tool is a click, if anything
  std::optional<cv::Rect2d> box;        ///< pixels of the left image; set if and only if it is seen
  double confidence = 0.0;              ///< 0..1, of `box`
  LearningState learning = LearningState::None;
  std::optional<cv::Point> pixel;  ///< centre of the box, or the operator's click
  /// Camera frame, metres. Of a click: as measured in this frame. Of a tracker: smoothed or, up to
  /// max_tool_age, carried on with its velocity; or by the load, see isHeld.
  std::optional<Eigen::Vector3f> point;
  std::optional<Eigen::Vector3f> velocity;  ///< metres a second; absent until it is known
  /// Seconds since the point was last measured, 0: in this frame; absent: never.
  std::optional<double> age;
  /// A depth was measured in `box`, but the tool cannot be there: the box may be on something else.
  bool isDoubted = false;
  bool isHeld = false;      ///< `point` is where the load is that the tool holds (HeldTool)
  bool hasGivenUp = false;  ///< lost, and not looked for any more: the tracker must be begun again
  std::shared_ptr<const ToolModel> model;  ///< what the tracker has learnt, where it learns
  std::string fault;                       ///< English: why what was asked for could not be done

  bool running() const { return state != TrackState::Idle; }
  /// A tracker runs, and does not know where the tool is: what belongs to it cannot be taken out.
  bool lost() const { return running() && !point; }
};

}  // namespace boomwatch
