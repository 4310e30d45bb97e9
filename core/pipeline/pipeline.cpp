#include "pipeline/pipeline.h"

#include <chrono>
#include <future>
#include <span>
#include <utility>

#include "pipeline/crane_stage.h"
#include "pipeline/frame_checks.h"
#include "pipeline/load_stage.h"
#include "pipeline/load_warning.h"
#include "pipeline/model_gate.h"
#include "pipeline/parameter_checks.h"
#include "pipeline/sensing_stage.h"
#include "pipeline/tool_stage.h"
#include "pipeline/watch_list.h"
#include "pipeline/watched_environment.h"

namespace boomwatch {
namespace {

/// Notes how long each stage took.
class StageClock {
 public:
  /// Passes on what the stage gave, and notes the time since the stage before.
  template <class Value>
  Value timed(std::string_view stage, Value value) {
    const auto now = std::chrono::steady_clock::now();
    m_timings.push_back({stage, std::chrono::duration<double, std::milli>(now - m_last).count()});
    m_last = now;
    return value;
  }
  std::vector<StageTiming> timings() const { return m_timings; }

 private:
  std::vector<StageTiming> m_timings;
  std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

/// The checks of a frame need only its picture and cloud: they run beside the stages up to the
/// model. Destroying the future waits for them.
[[nodiscard]] std::future<FrameChecks::Verdict> startChecks(FrameChecks& checks,
                                                            const FramePtr& frame,
                                                            const SensedFrame& sensed,
                                                            const ValidityParameters& parameters) {
  return std::async(std::launch::async,
                    [&checks, frame, image = sensed.image, cloud = sensed.cloud, parameters] {
                      return checks.examine(frame, image, *cloud, parameters);
                    });
}

double removedShare(const StaticScene& scene) {
  const std::size_t all = scene.statics.size() + scene.removed.size() + scene.noise.size();
  return all > 0 ? static_cast<double>(scene.removed.size()) / static_cast<double>(all) : 0.0;
}

/// Of a frame without a cloud.
Result unreadableResult(const FramePtr& frame, const SensedFrame& sensed,
                        const Parameters& parameters, const StageClock& clock) {
  Result result = noFrameResult(Reason::UnreadableFrame, parameters);
  result.frame = frame;
  result.image = sensed.image;
  result.message = sensed.fault;
  result.timings = clock.timings();
  return result;
}

/// What the stages made of one frame.
struct StageValues {
  const FramePtr& frame;
  const SensedFrame& sensed;
  const FrameChecks::Verdict& verdict;
  const ToolTrack& tool;
  const CarriedLoad& load;
  StaticScene&& scene;
  bool modelRebuilt;
  std::span<const std::size_t> suppressed;
  WatchList&& list;
  const LoadWarning::Outcome& warning;
  std::vector<StageTiming> timings;
  const Parameters& parameters;
};

Result assemble(StageValues&& values) {
  Result result;
  result.frame = values.frame;
  result.image = values.sensed.image;
  result.cloud = values.sensed.cloud;
  result.fill = values.verdict.fill;
  result.tool = values.tool;
  result.load = values.load.box;
  result.loadFault = values.load.fault;
  result.loadAge = values.load.age;
  result.loadVolume = values.load.volume;
  result.scene = std::move(values.scene);
  result.removedShare = removedShare(result.scene);
  result.clearance = std::move(values.list.clearance);
  result.watched = std::move(values.list.watched);
  result.leading = values.list.leading;
  result.suppressed.assign(values.suppressed.begin(), values.suppressed.end());
  result.approach = values.warning.approach;
  result.level = values.warning.level;
  if (const auto& nearest = result.clearance.nearest) {
    result.depthUncertainty = depthUncertainty(values.sensed, nearest->onEnvironment.z());
  }
  result.rowResidue = values.sensed.rowResidue;
  result.rowsCorrected = values.sensed.rowsCorrected;
  result.modelRebuilt = values.modelRebuilt;
  result.timings = std::move(values.timings);
  result.parameters = values.parameters;
  return result;
}

}  // namespace

/// The owners of all that outlives a frame.
struct Pipeline::State {
  explicit State(const TrackerMaker& maker) : tool(maker) {}

  SensingStage sensing;
  FrameChecks checks;
  ToolStage tool;
  LoadStage load;
  CraneStage crane;
  ModelGate gate;
  WatchedEnvironment environment;
  LoadWarning warning;
};

Pipeline::Pipeline(TrackerMaker maker)
    : m_maker(std::move(maker)), m_state(std::make_unique<State>(m_maker)) {}
Pipeline::~Pipeline() = default;

void Pipeline::order(const ToolOrder& order) {
  m_state->tool.order(order);
  m_state->load.forgetGrip();
}
void Pipeline::reset() { m_state = std::make_unique<State>(m_maker); }
const EnvironmentModel& Pipeline::model() const { return m_state->environment.model(); }

// The tracker starts after the matching, not beside it: OpenCV keeps a parallel loop to one thread
// while another thread is in one, and the matcher would take twice as long.
Result Pipeline::process(const FramePtr& frame, const Parameters& parameters) {
  validate(parameters);
  StageClock clock;
  State& s = *m_state;
  const MatchedFrame matched = s.sensing.match(*frame, parameters.stereo);
  std::future<void> looking = s.tool.startLooking(*frame, matched, parameters.tracking);
  const auto sensed = clock.timed("stereo", s.sensing.reproject(*frame, matched, parameters));
  if (!sensed.cloud) return unreadableResult(frame, sensed, parameters, clock);
  auto checking = startChecks(s.checks, frame, sensed, parameters.validity);
  SegmentedCloud segments = clock.timed("filter", segmentCloud(*sensed.cloud, parameters));
  const auto held = s.load.heldToolPoint(frame->stamp, parameters.validity.maxLoadAge);
  const ToolTrack tool = clock.timed(
      "tool", s.tool.locate(std::move(looking), *frame, *sensed.whole, held, parameters));
  const CarriedLoad load = clock.timed("load", s.load.update(*frame, sensed, tool, parameters));
  StaticScene scene = clock.timed(
      "crane", s.crane.separate(std::move(segments), *frame, sensed, tool, load, parameters));
  const FrameChecks::Verdict verdict = clock.timed("checks", checking.get());  // the wait for it
  const auto gate = s.gate.decide(frame->stamp, verdict, tool, load, scene, parameters);
  if (gate.forget) s.environment.forget();
  const bool rebuilt =
      clock.timed("model", gate.update && s.environment.update(*sensed.cloud, scene, parameters));
  const WatchInput input{chainFault(verdict, tool), gate.modelFault, tool, load, scene};
  WatchList list = watchList(input, s.environment, parameters);
  const auto warning = clock.timed(
      "clearance", s.warning.update({frame->stamp, load.box, list.clearance, list.isLoadLeading()},
                                    s.environment.exact(), parameters.warning));
  return assemble({frame, sensed, verdict, tool, load, std::move(scene), rebuilt,
                   s.environment.suppressed(), std::move(list), warning, clock.timings(),
                   parameters});
}

Result noFrameResult(Reason reason, const Parameters& parameters) {
  Result result;
  result.parameters = parameters;
  result.clearance = Clearance::unknown(reason);
  result.level = WarningLevel::NoDistance;
  return result;
}

}  // namespace boomwatch
