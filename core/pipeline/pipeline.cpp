#include "pipeline/pipeline.h"

#include <algorithm>
#include <chrono>
#include <future>

#include "base/error.h"
#include "cloud/depth_noise.h"
#include "collision/nearest_pair.h"
#include "crane/crane_boxes.h"
#include "load/held_tool.h"
#include "load/load_detector.h"
#include "load/load_follower.h"
#include "pipeline/frame_checks.h"
#include "pipeline/load_source.h"
#include "pipeline/parameter_checks.h"
#include "pipeline/warning_memory.h"
#include "pipeline/watched_environment.h"
#include "stereo/stereo_stage.h"

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

/// A quarter of a pixel is what matching leaves uncertain.
constexpr double matchingNoise = 0.25;

/// Pixels of disparity that a matcher's rim of a near thing may lack: beside it the block sees the
/// background as well.
constexpr double matcherSmear = 2.0;

/// Of a depth camera: dz = 0.0014 z^2 (a Kinect; Khoshelham and Elberink 2012).
constexpr double depthCameraNoise = 0.0014;

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
  LoadFollower loads;
  HeldTool held;
  CraneMemory craneMemory;
  WatchedEnvironment surroundings;
  LoadMotion motion;
  WarningMemory warning;
  std::optional<double> unmaskedSince;  ///< stamp from which the crane was not told from the scene
  bool craneIsTaught = false;           ///< by frames in which nobody had said where the tool is
  int untaught = 0;  ///< frames until the model may know what could have been the load
  std::shared_ptr<const Cloud> whole;  ///< of this frame; with the rims of tool and load
  double depthPerPixel = 0.0;          ///< 1 / (f B) of this frame's stereo pair; 0 if it is none

  bool sense(Result& result, std::future<void>& looking);
  std::future<void> look(const Result& result);
  std::optional<Eigen::Vector3f> toolByLoad(const Result& result) const;
  void holdTool(Result& result) const;
  /// Fills load, loadFault and loadAge; returns what is to be taken out of the cloud for it.
  std::optional<ViewedBox> findLoad(Result& result);
  StaticScene separate(SegmentedCloud segments, const Result& result);
  bool hasTaughtCrane(const Result& result);
  bool isEvidence(const Result& result, Reason frameFault);
  void countWithheld(const Result& result);
  Reason whyNothing(const Result& result, Reason frameFault) const;
  void judge(Result& result, Reason frameFault) const;
  Clearance around(const OrientedBox& box, const Parameters& parameters) const;
  Watched watchLoad(const Result& result) const;
  void watchCrane(Result& result) const;
  std::optional<double> depthUncertainty(const Clearance& clearance) const;
  std::optional<Approach> approach(const Result& result);
  void warn(Result& result);
};

Pipeline::Pipeline(TrackerMaker maker)
    : m_maker(std::move(maker)), m_state(std::make_unique<State>(m_maker)) {}
Pipeline::~Pipeline() = default;

void Pipeline::order(const ToolOrder& order) {
  m_state->tool.order(order);
  m_state->held.reset();  // whoever orders knows better
}
void Pipeline::reset() { m_state = std::make_unique<State>(m_maker); }
const EnvironmentModel& Pipeline::model() const { return m_state->surroundings.model(); }

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

  // Nothing before the model depends on what the frame is worth: meanwhile it is taken apart.
  auto checking = std::async(
      std::launch::async, [&state, frame, image = result.image, cloud = result.cloud, &parameters] {
        return state.checks.examine(frame, image, *cloud, parameters.validity);
      });
  SegmentedCloud segments = segmentCloud(*result.cloud, parameters);
  clock.lap("filter");
  if (looking.valid()) looking.get();
  result.tool =
      state.tool.locate(*state.whole, frame->stamp, parameters.tracking, state.toolByLoad(result));
  clock.lap("tool");

  result.loadVolume = state.findLoad(result);
  clock.lap("load");

  result.scene = state.separate(std::move(segments), result);
  result.removedShare = removedShare(result.scene);
  clock.lap("crane");

  const FrameChecks::Verdict verdict = checking.get();
  result.fill = verdict.fill;
  clock.lap("checks");  // as far as it had to be waited for

  // In this order: asked always, so that what is forgotten anyway is not forgotten again.
  if (state.hasTaughtCrane(result) || verdict.modelIsStale) state.surroundings.forget();
  if (state.isEvidence(result, verdict.reason)) {
    result.modelRebuilt = state.surroundings.learn(*result.cloud, result.scene, parameters);
    state.countWithheld(result);
    state.craneIsTaught = state.craneIsTaught || !isToolNamed(result);
  }
  clock.lap("model");

  state.judge(result, verdict.reason);
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
    whole = result.cloud = withoutDepthNoise(frame.cloud, result.parameters.filter.depthSmooth);
    return true;
  }
  try {
    const RectifiedPair pair =
        stereo.rectify(frame.left, frame.right, *frame.rig, result.parameters.stereo);
    result.image = pair.left;
    const cv::Mat matched = matchDisparity(pair.left, pair.right, result.parameters.stereo);
    // Not beside the matching: OpenCV keeps to one thread where anybody else is in one of its
    // parallel loops, and the matcher would take twice as long.
    looking = look(result);
    const StereoResult stereoResult = stereo.reconstruct(pair, matched, result.parameters.stereo);
    result.cloud = stereoResult.surfaces;
    whole = stereoResult.cloud;
    result.rowResidue = stereoResult.rowResidue;
    result.rowsCorrected = stereoResult.rowsCorrected;
    depthPerPixel = 1.0 / (stereoResult.focalLength * stereoResult.baseline);
    return true;
  } catch (const Error& fault) {
    result.message = fault.what();
    // The tool goes on all the same.
    if (!looking.valid() && !result.image.empty()) looking = look(result);
    return false;
  }
}

/// The tracker needs only the picture: it works while the cloud is taken apart.
std::future<void> Pipeline::State::look(const Result& result) {
  tool.offer(result.frame->tool, result.parameters.tracking.tracker);
  if (!tool.needsImage()) return {};
  return std::async(std::launch::async,
                    [this, image = result.image, tracking = result.parameters.tracking] {
                      tool.look(image, tracking);
                    });
}

/// Where the tool is by the load, as far as that was seen a moment ago.
std::optional<Eigen::Vector3f> Pipeline::State::toolByLoad(const Result& result) const {
  const double stamp = result.frame->stamp;
  const auto load = loads.expected(stamp, result.parameters.validity.maxLoadAge);
  return load ? held.point(*load, stamp) : std::nullopt;
}

/// Better than the tool's own velocity: what it holds is seen.
void Pipeline::State::holdTool(Result& result) const {
  ToolTrack& track = result.tool;
  if (!track.running() || track.age == 0.0) return;
  const auto point = toolByLoad(result);
  if (!point) return;
  track.point = point;
  track.isHeld = true;
}

std::optional<ViewedBox> Pipeline::State::findLoad(Result& result) {
  const LoadParameters& parameters = result.parameters.load;
  const double noise = depthPerPixel > 0.0 ? matchingNoise * depthPerPixel : depthCameraNoise;
  const LoadSource source = loadSource(result);
  const bool detected = source == LoadSource::Detected;
  if (detected && isToolNamed(result)) {
    holdTool(result);
    const double stamp = result.frame->stamp, maxAge = result.parameters.validity.maxLoadAge;
    const LoadDetection detection =
        result.tool.point ? detectLoad(*whole, *result.tool.point, noise, result.parameters.bounds,
                                       parameters, loads.expected(stamp, maxAge, result.tool.point))
                          : LoadDetection::refused(LoadFault::NoToolPoint);
    const auto followed = loads.follow(detection, stamp, parameters, maxAge, result.tool.point);
    result.load = followed.box;
    result.loadFault = detection.fault;
    result.loadAge = followed.age;
    if (!followed.box) held.reset();
    if (followed.age == 0.0 && result.tool.age == 0.0) {
      held.learn(*result.tool.point, *followed.box, stamp);
    }
  } else {
    loads.reset();
    held.reset();
    if (detected) result.loadFault = LoadFault::NoToolPoint;
    if (source == LoadSource::Manual) result.load = parameters.box();
    if (source == LoadSource::Scene) result.load = result.frame->load;
  }
  // Not the bare box: the load's own surface lies on it, and half of that would stay as obstacle.
  if (!result.load || !isUsable(*result.load)) return std::nullopt;
  const double margin = detected ? parameters.margin : result.parameters.model.resolution;
  return dynamicVolume(*result.load, margin, noise, matcherSmear * depthPerPixel);
}

StaticScene Pipeline::State::separate(SegmentedCloud segments, const Result& result) {
  craneMemory.forgetBefore(result.frame->stamp);
  // Where tool or boom are watched, too, what is near them must not be missing from the model.
  const WatchParameters& watch = result.parameters.watch;
  const bool unseenLoad =
      !result.load && loadSource(result) == LoadSource::Detected && !watch.tool && !watch.boom;
  StaticScene scene = separateStatic(std::move(segments), *result.cloud, result.tool.point,
                                     result.loadVolume, result.parameters, craneMemory, unseenLoad);
  craneMemory.note(result.frame->stamp, scene.toolCluster);
  craneMemory.note(result.frame->stamp, scene.boomCut);
  return scene;
}

/// Now that it is known where the tool is, but before that was, the model learnt the whole scene.
/// The crane would be an obstacle to its own load for as long as it takes to leave.
bool Pipeline::State::hasTaughtCrane(const Result& result) {
  return result.tool.point && std::exchange(craneIsTaught, false);
}

/// A frame that is no evidence of anything must not teach the model, nor make it forget. Nor must
/// one in which boom and load are taken for a part of the surroundings, be it that a leaf before
/// the tool was taken for its point; but where that goes on, as when they touch the ground for
/// long, they are better learnt, and warned of, than that nothing else is. Unless nobody is warned
/// of anything, because no load is seen: most likely the tracker has gone astray, and when it has
/// found the tool again the load would be in the middle of what the crane has taught.
bool Pipeline::State::isEvidence(const Result& result, Reason frameFault) {
  const double stamp = result.frame->stamp;
  const ToolMask mask = result.scene.toolMask;
  const bool astray = !result.load && loadSource(result) == LoadSource::Detected;
  if (mask != ToolMask::TooLarge && mask != ToolMask::NothingThere) {
    unmaskedSince.reset();
  } else if (!unmaskedSince || stamp < *unmaskedSince || astray) {
    unmaskedSince = stamp;
  }
  const bool unmasked =
      unmaskedSince && stamp - *unmaskedSince <= result.parameters.tracking.maxToolAge;
  return frameFault == Reason::None && !result.tool.lost() && !unmasked;
}

/// What may have been a load did not teach the model. When a load is found after all, or the tool
/// is watched from now on, the rest of that is surroundings, which are not known before they had
/// the time to enter.
void Pipeline::State::countWithheld(const Result& result) {
  if (result.scene.maybeLoad > 0) {
    untaught = framesToEnter(result.parameters.model).value_or(0);
  } else if (untaught > 0) {
    --untaught;
  }
}

/// The links of the chain that come before any distance, in the order in which they can fail.
Reason Pipeline::State::whyNothing(const Result& result, Reason frameFault) const {
  if (frameFault != Reason::None) return frameFault;
  return result.tool.lost() ? Reason::ToolLost : Reason::None;
}

void Pipeline::State::judge(Result& result, Reason frameFault) const {
  result.suppressed.assign(surroundings.suppressed().begin(), surroundings.suppressed().end());
  const Reason fault = whyNothing(result, frameFault);
  if (fault != Reason::None) {
    result.clearance = Clearance::unknown(fault);
    return;
  }
  if (result.parameters.watch.load) result.watched.push_back(watchLoad(result));
  watchCrane(result);
  result.leading = leadingOf(result.watched, result.parameters.warning);
  result.clearance = result.watched[result.leading].clearance;
}

Clearance Pipeline::State::around(const OrientedBox& box, const Parameters& parameters) const {
  return untaught > 0 ? Clearance::unknown(Reason::NoModel) : surroundings.around(box, parameters);
}

Watched Pipeline::State::watchLoad(const Result& result) const {
  const Reason fault = loadReason(result);
  const Clearance clearance =
      fault == Reason::None ? around(*result.load, result.parameters) : Clearance::unknown(fault);
  return {WatchedObject::Load, 0, result.load, clearance};
}

void Pipeline::State::watchCrane(Result& result) const {
  const WatchParameters& watch = result.parameters.watch;
  if (!watch.tool && !watch.boom) return;
  CraneBoxes crane;
  if (result.tool.point && result.scene.toolMask == ToolMask::Taken) {
    crane = craneBoxes(result.scene.toolCluster, *result.tool.point,
                       result.parameters.load.toolSize, result.loadVolume);
    const auto cut = boomSegments(result.scene.boomCut);
    crane.boom.insert(crane.boom.end(), cut.begin(), cut.end());
  }
  const auto add = [&](WatchedObject object, int segment, const std::optional<OrientedBox>& box) {
    const Clearance clearance =
        box ? around(*box, result.parameters) : Clearance::unknown(Reason::ToolNotSeen);
    result.watched.push_back({object, segment, box, clearance});
  };
  if (watch.tool) add(WatchedObject::Tool, 0, crane.tool);
  if (!watch.boom) return;
  if (crane.boom.empty()) add(WatchedObject::Boom, 0, std::nullopt);
  int segment = 0;
  for (const OrientedBox& box : crane.boom) add(WatchedObject::Boom, ++segment, box);
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
  const auto& nearest = result.clearance.nearest;
  const bool loadLeads = result.watched[result.leading].object == WatchedObject::Load;
  if (loadLeads && nearest && nearest->distance > 0.0) {
    approach.closingSpeed =
        velocity->dot(nearest->onEnvironment - nearest->onLoad) / nearest->distance;
  }
  const WarningParameters& limits = result.parameters.warning;
  approach.timeToContact = timeToContact(surroundings.exact(), *result.load, *velocity,
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
