#pragma once

#include <memory>

#include "pipeline/parameters.h"
#include "pipeline/result.h"

namespace boomwatch {

/// The whole chain, frame in, clearance out. Used by one thread.
class Pipeline {
 public:
  Pipeline();
  ~Pipeline();

  /// Never throws on what a frame holds: a frame that cannot be used gives a result that says why.
  /// Throws Error when `parameters` contradict each other (see validate).
  Result process(const FramePtr& frame, const Parameters& parameters);

  /// The pixel of the left image at which the operator sees the tool; absent: not known.
  void setToolPixel(std::optional<cv::Point> pixel);

  /// Forgets model, history and tool: another source follows.
  void reset();

  /// As the last frame left it; valid until the next process() or reset().
  const EnvironmentModel& model() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

/// A result for when there is no frame to process.
Result noFrameResult(Reason reason, const Parameters& parameters);

}  // namespace boomwatch
