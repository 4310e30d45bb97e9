#include "pipeline/pipeline.h"

#include <algorithm>
#include <chrono>

#include "collision/approach.h"
#include "collision/exact_clearance.h"
#include "collision/nearest_pair.h"
#include "collision/observed_share.h"
#include "collision/ray_clearance.h"
#include "frame/error.h"
#include "pipeline/frame_checks.h"
#include "pipeline/warning_machine.h"
#include "stereo/stereo_matcher.h"
#include "tracking/tool_point.h"

namespace boomwatch {
namespace {

/// Notes how long each stage took.
class StageClock {
 public:
  explicit StageClock(std::vector<StageTiming>& timings) : m_timings(timings) {}
  void lap(std::string_view stage) {
    const auto now = std::chrono::steady_clock::now();
    m_timings.push_back({stage, std::chrono::duration<double, std::milli>(now - m_last).count()});
    m_last = now;
  }

 private:
  std::vector<StageTiming>& m_timings;
  std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

/// Unknown is not clear, even where somebody asks for no share at all.
constexpr double noShare = 1e-9;

std::optional<OrientedBox> loadOf(const Frame& frame, const LoadParameters& parameters) {
  if (parameters.source == LoadSource::Manual) return parameters.box();
  return frame.load;
}

Reason loadFault(const std::optional<OrientedBox>& load, const Bounds& bounds) {
  if (!load || !isUsable(*load)) return Reason::NoLoad;
  return bounds.contains(load->centre.cast<float>()) ? Reason::None : Reason::LoadOutside;
}

}  // namespace

struct Pipeline::State {
  StereoStage stereo;
  FrameChecks checks;
  EnvironmentModel model;
  bool modelExists = false;
  ExactClearance exact;
  ObservedShare observed;
  Points evidence;  ///< scratch: what the model learns from this frame
  Points hidden;    ///< scratch: what shows neither that something is there nor that nothing is
  std::optional<cv::Point> toolPixel;
  LoadMotion motion;
  WarningMemory warning;
  double depthPerPixel = 0.0;  ///< 1 / (f B) of this frame's stereo pair; 0 if it is none

  bool sense(Result& result);
  void updateModel(Result& result);
  Clearance judge(const Result& result, Reason frameFault) const;
  Clearance measure(const OrientedBox& load, const Parameters& parameters) const;
  std::optional<double> depthUncertainty(const Clearance& clearance) const;
  std::optional<Approach> approach(const Result& result);
  void warn(Result& result);
};

Pipeline::Pipeline() : m_state(std::make_unique<State>()) {}
Pipeline::~Pipeline() = default;

void Pipeline::setToolPixel(std::optional<cv::Point> pixel) { m_state->toolPixel = pixel; }
void Pipeline::reset() { m_state = std::make_unique<State>(); }
const EnvironmentModel& Pipeline::model() const { return m_state->model; }

Result Pipeline::process(const FramePtr& frame, const Parameters& parameters) {
  validate(parameters);
  Result result = noFrameResult(Reason::UnreadableFrame, parameters);
  result.frame = frame;
  StageClock clock(result.timings);
  State& state = *m_state;

  const bool sensed = state.sense(result);
  clock.lap("stereo");
  if (!sensed) return result;

  const auto verdict =
      state.checks.examine(frame, result.image, *result.cloud, parameters.validity);
  result.fill = verdict.fill;
  result.toolPixel = state.toolPixel;
  if (state.toolPixel) result.toolPoint = toolPointAt(*result.cloud, *state.toolPixel);
  result.load = loadOf(*frame, parameters.load);
  clock.lap("checks");

  result.scene = separateStatic(*result.cloud, result.toolPoint, result.load, parameters);
  clock.lap("filter");

  if (verdict.modelIsStale) state.modelExists = false;
  // A frame that is no evidence of anything must not teach the model, nor make it forget.
  if (verdict.reason == Reason::None) state.updateModel(result);
  clock.lap("model");

  result.clearance = state.judge(result, verdict.reason);
  result.depthUncertainty = state.depthUncertainty(result.clearance);
  result.approach = state.approach(result);
  state.warn(result);
  clock.lap("clearance");
  return result;
}

/// Fills image and cloud. False, with the reason in `message`, when the frame cannot be used.
bool Pipeline::State::sense(Result& result) {
  const Frame& frame = *result.frame;
  depthPerPixel = 0.0;
  if (!frame.rig) {
    result.image = frame.left;
    result.cloud = frame.cloud;
    if (!result.cloud) result.message = "The frame holds neither a cloud nor a stereo pair.";
    return result.cloud != nullptr;
  }
  try {
    StereoResult stereoResult =
        stereo.process(frame.left, frame.right, *frame.rig, result.parameters.stereo);
    result.image = stereoResult.left;
    result.cloud = stereoResult.cloud;
    result.rowResidue = stereoResult.rowResidue;
    result.rowsCorrected = stereoResult.rowsCorrected;
    depthPerPixel = 1.0 / (stereoResult.focalLength * stereoResult.baseline);
    return true;
  } catch (const Error& fault) {
    result.message = fault.what();
    return false;
  }
}

void Pipeline::State::updateModel(Result& result) {
  const GridGeometry geometry(result.parameters.bounds, result.parameters.model.resolution);
  if (!modelExists || !(model.geometry() == geometry)) {
    model = EnvironmentModel(geometry);
    modelExists = true;
    result.modelRebuilt = true;
  }
  evidence = result.scene.statics;
  evidence.insert(evidence.end(), result.scene.beyond.begin(), result.scene.beyond.end());
  // Noise is not believed, but neither does it show that nothing is there.
  hidden = result.scene.removed;
  hidden.insert(hidden.end(), result.scene.noise.begin(), result.scene.noise.end());
  model.update(evidence, result.parameters.model, hidden);
  exact.rebuild(model);
  observed.rebuild(model);
}

/// The validity of the whole chain, in the order in which its links can fail.
Clearance Pipeline::State::judge(const Result& result, Reason frameFault) const {
  const Parameters& parameters = result.parameters;
  if (frameFault != Reason::None) return Clearance::unknown(frameFault);
  const Reason fault = loadFault(result.load, parameters.bounds);
  if (fault != Reason::None) return Clearance::unknown(fault);
  const auto needed = framesToEnter(parameters.model);
  if (!needed || model.frames() < static_cast<std::size_t>(*needed)) {
    return Clearance::unknown(Reason::NoModel);
  }
  return measure(*result.load, parameters);
}

Clearance Pipeline::State::measure(const OrientedBox& load, const Parameters& parameters) const {
  const ClearanceParameters& method = parameters.clearance;
  Clearance clearance = method.method == ClearanceMethod::Exact
                            ? exact.query(load, method.range)
                            : rayClearance(model, load, method.interval, method.radius);
  const double searched = searchReach(parameters);
  // Rays may meet something farther away than they are long, in front of what they did not reach.
  if (searchIsShort(parameters) &&
      !(clearance.nearest && clearance.nearest->distance <= searched)) {
    clearance.state = ClearanceState::Unknown;
    clearance.reason = Reason::SearchTooShort;
    clearance.nearest.reset();
  }
  // With nothing in range, "clear" promises something about the caution zone.
  const double reach = clearance.nearest ? clearance.nearest->distance
                                         : std::min(searched, parameters.warning.cautionDistance);
  const double share = observed.query(load, reach) * watchedDepth(load, reach, parameters.bounds);
  if (share < std::max(parameters.validity.minObserved, noShare) &&
      !(clearance.nearest && reach == 0.0)) {
    clearance = Clearance::unknown(Reason::NothingObserved);
  }
  clearance.observedShare = share;
  return clearance;
}

/// What a quarter of a pixel of disparity does to the depth there, from Eq. 5: dz = z^2 / (f B) dd.
std::optional<double> Pipeline::State::depthUncertainty(const Clearance& clearance) const {
  if (!clearance.nearest || depthPerPixel == 0.0) return std::nullopt;
  const double z = clearance.nearest->onEnvironment.z();
  return 0.25 * z * z * depthPerPixel;
}

std::optional<Approach> Pipeline::State::approach(const Result& result) {
  if (!result.load) {
    motion.reset();
    return std::nullopt;
  }
  const auto velocity = motion.update(result.frame->stamp, result.load->centre);
  if (!velocity || result.clearance.state == ClearanceState::Unknown) return std::nullopt;
  Approach approach;
  approach.velocity = *velocity;
  if (const auto& nearest = result.clearance.nearest; nearest && nearest->distance > 0.0) {
    approach.closingSpeed =
        velocity->dot(nearest->onEnvironment - nearest->onLoad) / nearest->distance;
  }
  const WarningParameters& limits = result.parameters.warning;
  approach.timeToContact = timeToContact(exact, *result.load, *velocity,
                                         std::max(limits.cautionTime, limits.warningTime));
  return approach;
}

void Pipeline::State::warn(Result& result) {
  warning = nextWarning(warning, {result.frame->stamp, result.clearance, result.approach},
                        result.parameters.warning);
  result.level = warning.level;
}

Result noFrameResult(Reason reason, const Parameters& parameters) {
  Result result;
  result.parameters = parameters;
  result.clearance = Clearance::unknown(reason);
  result.level = WarningLevel::NoDistance;
  return result;
}

}  // namespace boomwatch
