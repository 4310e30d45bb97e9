#pragma once

#include "frame/clearance.h"
#include "frame/frame.h"
#include "parameters/parameters.h"
#include "pipeline/scene_motion.h"

namespace boomwatch {

/// Tells from the frames alone whether the chain may be trusted. Used by one thread.
class FrameChecks {
 public:
  struct Verdict {
    Reason reason = Reason::None;
    double fill = 0.0;  ///< share of the cloud that was measured
    /// What was learnt before holds no more: the camera has moved for too long, or this frame is
    /// from another time (a recording was wound back or on, or begins anew).
    bool modelIsStale = false;
  };

  /// `image` and `cloud` are what the frame was turned into: rectified left, organised cloud.
  Verdict examine(const FramePtr& frame, const cv::Mat& image, const Cloud& cloud,
                  const ValidityParameters& parameters);
  /// Forgets all frames: another source follows.
  void reset();

 private:
  bool repeats(const FramePtr& frame) const;
  bool isFromAnotherTime(const Frame& frame) const;

  FramePtr m_previous;
  int m_equalFrames = 1;
  int m_movingFrames = 0;
  SceneMotion m_motion;
};

}  // namespace boomwatch
