#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "simulation/yard/yard_obstacles.h"

namespace boomwatch {

/// All that is known about a frame of demo:yard because it was made. Camera frame (the left
/// camera's), metres; images are of the left picture's size. Immutable; any thread.
struct YardTruth {
  static constexpr double farthest = 30.0;  ///< metres in z beyond which depth is left out

  cv::Mat depth;                     ///< CV_32FC1, z; NaN where nothing is nearer than `farthest`
  cv::Mat kind;                      ///< CV_8UC1, a YardKind
  double depthTimesDisparity = 0.0;  ///< f B, pixels times metres (Eq. 5)

  Eigen::Vector3d toolPoint = Eigen::Vector3d::Zero();  ///< amid the rotator, inside the tool
  cv::Point2d toolPixel;     ///< to which toolPoint projects; may be outside the picture
  cv::Rect toolBox;          ///< around all of the tool, hidden or not; empty if out of the picture
  double toolVisible = 0.0;  ///< share of the tool's pixels that nothing hides, 0..1

  OrientedBox load;                    ///< x along the log
  Cylinder log;                        ///< which it just encloses
  YardApproach nearest;                ///< of everything that has its place, seen or not; exact
  std::optional<YardApproach> person;  ///< absent without a person
  std::optional<YardApproach> branch;  ///< the nearest swaying one; absent without clutter

  /// The ground, and then each thing that has its place. Takes some milliseconds.
  std::function<std::vector<YardApproach>()> everything;

  /// CV_32FC1, pixels; NaN where depth is.
  cv::Mat disparity() const;
  /// CV_8UC1: 255 where something moves (crane, load, person, clutter), else 0.
  cv::Mat moving() const;
};

}  // namespace boomwatch
