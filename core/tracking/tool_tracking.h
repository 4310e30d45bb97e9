#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <variant>

#include "frame/cloud.h"
#include "tracking/make_tracker.h"
#include "tracking/tool_motion.h"
#include "tracking/tool_track.h"

namespace boomwatch {

/// The tool is in this box of the next picture; what was learnt before is forgotten.
struct TrackBox {
  cv::Rect2d box;  ///< pixels of the left image
};
/// The tool is what this model knows; never null.
struct TrackModel {
  std::shared_ptr<const ToolModel> model;
};
/// Begin anew where the tool was last seen; what was learnt since is forgotten.
struct TrackAgain {};
/// The tool is at this pixel, and stays there; no tracker runs.
struct PickTool {
  cv::Point pixel;
};
/// Nobody knows where the tool is; no tracker runs.
struct ForgetTool {};
/// What a person says about the tool. The latest holds.
using ToolOrder = std::variant<TrackBox, TrackModel, TrackAgain, PickTool, ForgetTool>;

/// Makes the tracker of a kind; null for Manual.
using TrackerMaker = std::function<std::unique_ptr<Tracker>(TrackerKind)>;

/// Owns the tracker of the chosen kind, and says where the tool is (docs/method.md section 3).
///
/// A frame is one look() and then one locate(); look() may run in another thread meanwhile.
class ToolTracking {
 public:
  explicit ToolTracking(TrackerMaker maker = makeTracker);

  /// Taken up by the next look(). One that cannot be obeyed leaves a tracker that runs as it is,
  /// and the reason in ToolTrack::fault; where none runs, the tool counts as lost until another
  /// order.
  void order(const ToolOrder& order) {
    m_order = order;
    m_told = true;
  }
  /// What the source says about it, to begin with: taken up unless a person has ever said anything,
  /// or the tracker is Manual. Only the first counts.
  void offer(const std::optional<cv::Rect2d>& box, TrackerKind kind);
  /// Whether look() has something to do.
  bool needsImage() const;

  /// Finds the tool in the left image. A new kind of tracker begins with the box in which the old
  /// one last saw the tool; Manual with that box's middle. Never throws.
  void look(const cv::Mat& image, const TrackingParameters& parameters) noexcept;

  /// Where that is in space. `stamp`: seconds on the source's clock. `held`: see ToolMotion.
  ToolTrack locate(const Cloud& cloud, double stamp, const TrackingParameters& parameters,
                   const std::optional<Eigen::Vector3f>& held = {});

 private:
  void obey(const TrackBox& order, const cv::Mat& image, TrackerKind kind);
  void obey(const TrackModel& order, const cv::Mat& image, TrackerKind kind);
  void obey(const TrackAgain& order, const cv::Mat& image, TrackerKind kind);
  void obey(const PickTool& order, const cv::Mat& image, TrackerKind kind);
  void obey(const ForgetTool& order, const cv::Mat& image, TrackerKind kind);
  void takeOrder(const cv::Mat& image, TrackerKind kind);
  void changeKind(TrackerKind kind);
  template <class Begin>
  void begin(TrackerKind kind, Begin&& begin);
  void beginAgain(TrackerKind kind);
  void stop();
  void reject();

  struct Sight {
    cv::Mat image;
    cv::Rect2d box;  ///< the part of it that is inside the image
  };

  TrackerMaker m_make;
  std::optional<ToolOrder> m_order;
  bool m_told = false;  ///< somebody said where the tool is
  std::unique_ptr<Tracker> m_tracker;
  TrackerKind m_kind = TrackerKind::Manual;  ///< of m_tracker
  bool m_wanted = false;                     ///< a person asked for a tracker
  Track m_track;
  std::optional<Sight> m_seen;                ///< where the tool was last seen
  std::optional<Sight> m_sure;                ///< the same, and its point was where it can be
  std::shared_ptr<const ToolModel> m_loaded;  ///< what TrackModel gave
  std::optional<cv::Point> m_click;
  ToolMotion m_motion;
  std::string m_fault;
};

}  // namespace boomwatch
