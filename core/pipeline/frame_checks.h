#pragma once

#include "frame/clearance.h"
#include "frame/frame.h"
#include "parameters/parameters.h"
#include "pipeline/scene_motion.h"
#include "tracking/tool_track.h"

namespace boomwatch {

/// Tells from the frames alone whether the chain may be trusted. Owns the history of the frames:
/// repeats, lost frames, motion of the whole picture. Used by one thread at a time.
class FrameChecks {
 public:
  struct Verdict {
    Reason reason = Reason::None;
    double fill = 0.0;  ///< share of the cloud that was measured
    /// The model holds no more: the camera has moved for too long, or this frame is from another
    /// time (a recording was wound back or on, or begins anew).
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

/// Why a frame gives no distance, whatever is near: the first fault of the chain before the model.
/// None when the chain holds so far. Pure.
Reason chainFault(const FrameChecks::Verdict& verdict, const ToolTrack& tool);

}  // namespace boomwatch
