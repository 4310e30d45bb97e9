#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>

#include "frame/cloud.h"
#include "frame/oriented_box.h"

namespace boomwatch {

struct StereoRig;  // frame/stereo_rig.h

/// One moment, as a source delivers it. Immutable once it is delivered; shared between threads.
///
/// A stereo source gives `left`, `right` and `rig`, and the pipeline makes the cloud. Every other
/// source gives `cloud`, and `left` where it has a picture of the same size.
struct Frame {
  std::uint64_t sequence = 0;            ///< index in the source, from 0
  double stamp = 0.0;                    ///< seconds on the source's own clock
  cv::Mat left;                          ///< CV_8UC1 or CV_8UC3 (BGR); empty if there is no picture
  cv::Mat right;                         ///< as left; empty unless stereo
  std::shared_ptr<const StereoRig> rig;  ///< set with `right`
  std::shared_ptr<const Cloud> cloud;    ///< set unless stereo
  std::optional<OrientedBox> load;       ///< where the source itself knows the load (demo scenes)
  /// Where the source itself knows the tool: a box to begin to follow it with, pixels of `left`.
  std::optional<cv::Rect2d> tool;
  /// Of simulated frames: metres, load to the nearest static surface; 0 when they touch.
  std::optional<double> trueDistance;
  bool still = false;  ///< repeated on purpose: that it equals the last one is no fault
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace boomwatch
