#pragma once

#include <memory>

#include "parameters/parameters.h"
#include "pipeline/result.h"
#include "tracking/make_tracker.h"
#include "tracking/tool_tracking.h"

namespace boomwatch {

/// The whole chain, frame in, clearance out. Used by one thread.
class Pipeline {
 public:
  /// `maker` makes the trackers; another one in tests.
  explicit Pipeline(TrackerMaker maker = makeTracker);
  ~Pipeline();

  /// Never throws on what a frame holds: a frame that cannot be used gives a result that says why.
  /// Throws Error when `parameters` contradict each other (see validate).
  Result process(const FramePtr& frame, const Parameters& parameters);

  /// What the operator says about the tool; obeyed with the next frame that has a picture. What
  /// cannot be obeyed is said in Result::tool.
  void order(const ToolOrder& order);

  /// Forgets model, history and tool: another source follows.
  void reset();

  /// As the last frame left it; valid until the next process() or reset().
  const EnvironmentModel& model() const;

 private:
  struct State;
  TrackerMaker m_maker;
  std::unique_ptr<State> m_state;
};

/// A result for when there is no frame to process.
Result noFrameResult(Reason reason, const Parameters& parameters);

}  // namespace boomwatch
