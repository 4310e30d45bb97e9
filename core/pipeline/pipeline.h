#pragma once

#include <memory>

#include "parameters/parameters.h"
#include "pipeline/result.h"
#include "tracking/make_tracker.h"
#include "tracking/tool_tracking.h"

namespace boomwatch {

/// The whole chain: a frame in, a clearance out. process() passes values from owner to owner; each
/// owner keeps what it needs of earlier frames. Used by one thread; process() starts threads of its
/// own and waits for them.
class Pipeline {
 public:
  /// `maker` makes the trackers; another one in tests.
  explicit Pipeline(TrackerMaker maker = makeTracker);
  ~Pipeline();

  /// Does not throw on the content of a frame: one that cannot be used gives a result with the
  /// reason. Throws Error when `parameters` contradict each other (see validate).
  Result process(const FramePtr& frame, const Parameters& parameters);

  /// The operator's order about the tool. Takes effect with the next frame that has a picture; an
  /// order that cannot be carried out is reported in Result::tool.
  void order(const ToolOrder& order);

  /// Forgets model, history and tool: another source follows.
  void reset();

  /// The model after the last frame; valid until the next process() or reset().
  const EnvironmentModel& model() const;

 private:
  struct State;
  TrackerMaker m_maker;
  std::unique_ptr<State> m_state;
};

/// A result for when there is no frame to process.
Result noFrameResult(Reason reason, const Parameters& parameters);

}  // namespace boomwatch
