#include "pipeline/pipeline.h"

#include <algorithm>
#include <chrono>
#include <future>

#include "collision/approach.h"
#include "collision/exact_clearance.h"
#include "collision/nearest_pair.h"
#include "collision/observed_share.h"
#include "collision/ray_clearance.h"
#include "frame/error.h"
#include "load/load_detector.h"
#include "load/load_follower.h"
#include "pipeline/frame_checks.h"
#include "pipeline/warning_machine.h"
#include "stereo/stereo_matcher.h"

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

/// A quarter of a pixel is what matching leaves uncertain.
constexpr double matchingNoise = 0.25;

/// Of a depth camera: dz = 0.0014 z^2 (a Kinect; Khoshelham and Elberink 2012).
constexpr double depthCameraNoise = 0.0014;

Reason loadReason(const Result& result) {
  const std::optional<OrientedBox>& load = result.load;
  const Bounds& bounds = result.parameters.bounds;
  if (!load && result.parameters.load.source == LoadSource::Detected) return Reason::LoadNotSeen;
  if (!load || !isUsable(*load)) return Reason::NoLoad;
  return bounds.contains(load->centre.cast<float>()) ? Reason::None : Reason::LoadOutside;
}

double removedShare(const StaticScene& scene) {
  const std::size_t all = scene.statics.size() + scene.removed.size() + scene.noise.size();
  return all > 0 ? static_cast<double>(scene.removed.size()) / static_cast<double>(all) : 0.0;
}

}  // namespace

struct Pipeline::State {
  explicit State(const TrackerMaker& maker) : tool(maker) {}

  StereoStage stereo;
  ToolTracking tool;
  FrameChecks checks;
  EnvironmentModel model;
  bool modelExists = false;
  LoadFollower loads;
  ExactClearance exact;
  ObservedShare observed;
  Points evidence;  ///< scratch: what the model learns from this frame
  Points hidden;    ///< scratch: what shows neither that something is there nor that nothing is
  LoadMotion motion;
  WarningMemory warning;
  double depthPerPixel = 0.0;  ///< 1 / (f B) of this frame's stereo pair; 0 if it is none

  bool sense(Result& result, std::future<void>& looking);
  std::future<void> look(const Result& result);
  /// Fills load, loadFault and loadAge; returns what is to be taken out of the cloud for it.
  std::optional<OrientedBox> findLoad(Result& result);
  void updateModel(Result& result);
  Clearance judge(const Result& result, Reason frameFault) const;
  Clearance measure(const OrientedBox& load, const Parameters& parameters) const;
  std::optional<double> depthUncertainty(const Clearance& clearance) const;
  std::optional<Approach> approach(const Result& result);
  void warn(Result& result);
};

Pipeline::Pipeline(TrackerMaker maker)
    : m_maker(std::move(maker)), m_state(std::make_unique<State>(m_maker)) {}
Pipeline::~Pipeline() = default;

void Pipeline::order(const ToolOrder& order) { m_state->tool.order(order); }
void Pipeline::reset() { m_state = std::make_unique<State>(m_maker); }
const EnvironmentModel& Pipeline::model() const { return m_state->model; }

Result Pipeline::process(const FramePtr& frame, const Parameters& parameters) {
  validate(parameters);
  Result result = noFrameResult(Reason::UnreadableFrame, parameters);
  result.frame = frame;
  StageClock clock(result.timings);
  State& state = *m_state;

  std::future<void> looking;  // the tracker at work; it is waited for, whatever happens below
  const bool sensed = state.sense(result, looking);
  clock.lap("stereo");
  if (!sensed) return result;

  const auto verdict =
      state.checks.examine(frame, result.image, *result.cloud, parameters.validity);
  result.fill = verdict.fill;
  clock.lap("checks");

  if (looking.valid()) looking.get();
  result.tool = state.tool.locate(*result.cloud, frame->stamp, parameters.tracking);
  clock.lap("tool");

  const std::optional<OrientedBox> loadVolume = state.findLoad(result);
  clock.lap("load");

  result.scene = separateStatic(*result.cloud, result.tool.point, loadVolume, parameters);
  result.removedShare = removedShare(result.scene);
  clock.lap("filter");

  if (verdict.modelIsStale) state.modelExists = false;
  // A frame that is no evidence of anything must not teach the model, nor make it forget. Nor must
  // one in which the boom is taken for a part of the surroundings.
  const bool isEvidence = verdict.reason == Reason::None && !result.tool.lost();
  if (isEvidence) state.updateModel(result);
  clock.lap("model");

  result.clearance = state.judge(result, verdict.reason);
  result.depthUncertainty = state.depthUncertainty(result.clearance);
  result.approach = state.approach(result);
  state.warn(result);
  clock.lap("clearance");
  return result;
}

/// Fills image and cloud. False, with the reason in `message`, when the frame cannot be used.
bool Pipeline::State::sense(Result& result, std::future<void>& looking) {
  const Frame& frame = *result.frame;
  depthPerPixel = 0.0;
  if (!frame.rig) {
    result.image = frame.left;
    result.cloud = frame.cloud;
    if (!result.cloud) {
      result.message = "The frame holds neither a cloud nor a stereo pair.";
      return false;
    }
    looking = look(result);
    return true;
  }
  try {
    const RectifiedPair pair =
        stereo.rectify(frame.left, frame.right, *frame.rig, result.parameters.stereo);
    result.image = pair.left;
    looking = look(result);
    StereoResult stereoResult = stereo.match(pair, result.parameters.stereo);
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

/// The tracker and the stereo matcher need only the picture: one works while the other does.
std::future<void> Pipeline::State::look(const Result& result) {
  if (!tool.needsImage()) return {};
  return std::async(std::launch::async,
                    [this, image = result.image, tracking = result.parameters.tracking] {
                      tool.look(image, tracking);
                    });
}

std::optional<OrientedBox> Pipeline::State::findLoad(Result& result) {
  const LoadParameters& parameters = result.parameters.load;
  const double noise = depthPerPixel > 0.0 ? matchingNoise * depthPerPixel : depthCameraNoise;
  if (parameters.source == LoadSource::Detected) {
    const double stamp = result.frame->stamp, maxAge = result.parameters.validity.maxLoadAge;
    const LoadDetection detection =
        result.tool.point ? detectLoad(*result.cloud, *result.tool.point, noise,
                                       result.parameters.bounds, parameters,
                                       loads.expected(stamp, maxAge, result.tool.point))
                          : LoadDetection::refused(LoadFault::NoToolPoint);
    const auto followed = loads.follow(detection, stamp, parameters, maxAge, result.tool.point);
    result.load = followed.box;
    result.loadFault = detection.fault;
    result.loadAge = followed.age;
  } else {
    loads.reset();
    result.load = parameters.source == LoadSource::Manual ? parameters.box() : result.frame->load;
  }
  // Not the bare box: the load's own surface lies on it, and half of that would stay as obstacle.
  if (!result.load || !isUsable(*result.load)) return std::nullopt;
  const bool detected = parameters.source == LoadSource::Detected;
  const double margin = detected ? parameters.margin : result.parameters.model.resolution;
  return dynamicVolume(*result.load, margin, noise);
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
  if (result.tool.lost()) return Clearance::unknown(Reason::ToolLost);
  const Reason fault = loadReason(result);
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
  return matchingNoise * z * z * depthPerPixel;
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
