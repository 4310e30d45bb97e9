#include "tracking/tool_tracking.h"

#include <exception>
#include <utility>

#include "base/error.h"
#include "tracking/tool_point.h"

namespace boomwatch {
namespace {

void requireTracker(TrackerKind kind) {
  if (kind != TrackerKind::Manual) return;
  throw Error("tracker", "manual follows nothing", "Set tracker to tld, cmt, klt or csrt.");
}

}  // namespace

ToolTracking::ToolTracking(TrackerMaker maker) : m_make(std::move(maker)) {}

void ToolTracking::offer(const std::optional<cv::Rect2d>& box, TrackerKind kind) {
  if (!box || m_told || kind == TrackerKind::Manual) return;
  order(TrackBox{*box});
}

bool ToolTracking::needsImage() const { return m_order || m_wanted; }

void ToolTracking::look(const cv::Mat& image, const TrackingParameters& parameters) noexcept {
  m_fault.clear();
  takeOrder(image, parameters.tracker);
  if (m_wanted && m_kind != parameters.tracker) changeKind(parameters.tracker);
  if (!m_wanted) return;
  m_track = Track::lost();
  if (!m_tracker) return;
  try {
    m_tracker->setLearning(parameters.learn);
    m_track = m_tracker->track(image);
  } catch (const std::exception& fault) {
    m_fault = fault.what();
  }
  if (!m_track.box) return;
  const cv::Rect2d inside = *m_track.box & cv::Rect2d({}, cv::Size2d(image.size()));
  m_seen = Sight{image, inside};
}

void ToolTracking::takeOrder(const cv::Mat& image, TrackerKind kind) {
  const std::optional<ToolOrder> order = std::exchange(m_order, std::nullopt);
  if (!order) return;
  try {
    std::visit([&](const auto& known) { obey(known, image, kind); }, *order);
  } catch (const std::exception& fault) {
    m_fault = fault.what();
    if (m_tracker || kind == TrackerKind::Manual) return;
    m_wanted = true;
    m_kind = kind;
    m_click.reset();
  }
}

/// A fresh tracker each time: when it cannot begin, the old one is as it was.
template <class Begin>
void ToolTracking::begin(TrackerKind kind, Begin&& begin) {
  std::unique_ptr<Tracker> fresh = m_make(kind);
  if (fresh) begin(*fresh);
  stop();
  m_tracker = std::move(fresh);
  m_kind = kind;
  m_wanted = m_tracker != nullptr;
}

void ToolTracking::stop() {
  m_tracker.reset();
  m_wanted = false;
  m_track = Track::idle();
  m_click.reset();
  m_motion.reset();
}

void ToolTracking::obey(const TrackBox& order, const cv::Mat& image, TrackerKind kind) {
  begin(kind, [&](Tracker& fresh) { fresh.start(image, order.box); });
  m_seen = m_sure = Sight{image, order.box};
  m_loaded.reset();
  if (!m_wanted) m_click = centreOf(order.box);
}

void ToolTracking::obey(const TrackModel& order, const cv::Mat&, TrackerKind kind) {
  requireTracker(kind);
  begin(kind, [&](Tracker& fresh) { fresh.start(*order.model); });
  m_seen.reset();
  m_sure.reset();
  m_loaded = order.model;
}

void ToolTracking::obey(const TrackAgain&, const cv::Mat&, TrackerKind kind) { beginAgain(kind); }

void ToolTracking::obey(const PickTool& order, const cv::Mat&, TrackerKind) {
  stop();
  m_click = order.pixel;
}

void ToolTracking::obey(const ForgetTool&, const cv::Mat&, TrackerKind) {
  stop();
  m_seen.reset();
  m_sure.reset();
  m_loaded.reset();
}

void ToolTracking::beginAgain(TrackerKind kind) {
  requireTracker(kind);
  if (!m_seen && !m_loaded) {
    throw Error("tool", "it has not been seen yet", "Draw a box around it.");
  }
  begin(kind, [&](Tracker& fresh) {
    m_seen ? fresh.start(m_seen->image, m_seen->box) : fresh.start(*m_loaded);
  });
}

void ToolTracking::changeKind(TrackerKind kind) {
  if (kind == TrackerKind::Manual) {
    const std::optional<cv::Rect2d> last = m_track.box;
    stop();
    if (last) m_click = centreOf(*last);
    return;
  }
  const ToolMotion motion = m_motion;  // the tool goes on where it was
  try {
    beginAgain(kind);
  } catch (const std::exception& fault) {
    m_fault = fault.what();
    m_tracker.reset();
    m_kind = kind;
  }
  m_motion = motion;
}

/// What the tracker follows is not the tool.
void ToolTracking::reject() {
  if (m_tracker) m_tracker->reject();
  m_track = {TrackState::Lost, std::nullopt, 0.0, m_track.learning};
  m_seen = m_sure;
}

ToolTrack ToolTracking::locate(const Cloud& cloud, double stamp,
                               const TrackingParameters& parameters,
                               const std::optional<Eigen::Vector3f>& held) {
  ToolTrack tool;
  tool.fault = m_fault;
  if (!m_wanted) {
    tool.pixel = m_click;
    if (m_click) tool.point = toolPointAt(cloud, *m_click);
    if (tool.point) tool.age = 0.0;
    return tool;
  }
  std::optional<Eigen::Vector3f> measured;
  if (m_track.box) measured = toolPointIn(cloud, *m_track.box, parameters.toolPoint);
  m_motion.update(stamp, measured, parameters, held);
  if (m_motion.contradicted()) reject();
  if (m_motion.believed()) m_sure = m_seen;
  tool.state = m_track.state == TrackState::Idle ? TrackState::Lost : m_track.state;
  tool.learning = m_track.learning;
  tool.box = m_track.box;
  tool.confidence = m_track.confidence;
  if (tool.box) tool.pixel = centreOf(*tool.box);
  tool.isDoubted = tool.box && measured && !m_motion.believed();
  tool.hasGivenUp = m_tracker && m_tracker->hasGivenUp();
  if (m_tracker) tool.model = m_tracker->model();
  tool.point = m_motion.point();
  tool.velocity = m_motion.velocity();
  tool.age = m_motion.age();
  return tool;
}

}  // namespace boomwatch
