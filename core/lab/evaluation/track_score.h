#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <span>

#include "lab/evaluation/ground_truth.h"
#include "tracking/tracker.h"

namespace boomwatch {

/// What a tracker said of one frame, and how long it took to say it.
struct TrackedFrame {
  Track track;
  double seconds = 0.0;
};

/// How well a tracker did. Table 5 of the thesis (docs/method.md section 3), then what the field
/// reports ("Object Tracking Benchmark", Wu et al., 2015), then what this job needs. Absent is what
/// no frame told.
struct TrackScore {
  std::size_t frames = 0;                  ///< without the first, whose box was given
  std::size_t lost = 0;                    ///< frames without a box
  std::size_t occluded = 0;                ///< frames in which the target cannot be seen
  std::optional<double> lostShare;         ///< of all frames: Lost (%)
  std::optional<double> accuracy;          ///< share with a box, of those in which it can be seen
  std::optional<double> confidenceMean;    ///< over the frames with a box
  std::optional<double> confidenceSpread;  ///< standard deviation of the same
  std::optional<double> fps;               ///< mean of 1/t over the frames with a box

  std::optional<double> successArea;  ///< AUC: mean share of overlaps above 0, 0.05, ... 1
  std::optional<double> precision;    ///< share of centres at most 20 pixels off

  std::size_t falseBoxes = 0;  ///< boxes given while the target cannot be seen
  std::size_t returns = 0;     ///< how often the target came back into sight
  std::size_t refound = 0;     ///< of those, found within refoundWithin frames
  /// Of the returns, those of a target that the tracker was on when it went out of sight: what it
  /// had lost before, it cannot find *again*.
  std::size_t followed = 0;
  std::size_t followedRefound = 0;  ///< of those, found within refoundWithin frames
};

/// Frames, from the first in which the target is seen again, in which it must be found.
inline constexpr std::size_t refoundWithin = 15;
/// Overlap with the truth from which a box is on the target, not on something else.
inline constexpr double refoundOverlap = 0.25;

/// Intersection over union: 0 apart .. 1 the same.
double overlapOf(const cv::Rect2d& a, const cv::Rect2d& b);

/// `frames` and `truth` have one length; the frame in which the tracker was started is in neither.
/// Visible frames without a box count as overlap 0. `hasConfidence`: whether the tracker gives one.
TrackScore scoreOf(std::span<const TrackedFrame> frames,
                   std::span<const std::optional<cv::Rect2d>> truth, bool hasConfidence = true);

/// Over sequences, as Table 5's last row: counts are added up, shares are means of the sequences
/// that have them, each counting the same.
TrackScore meanOf(std::span<const TrackScore> scores);

}  // namespace boomwatch
