#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string_view>

#include "parameters/parameters.h"

namespace boomwatch {

struct ToolModel;  // tracking/tool_model.h

/// Where a tracker stands with its target after an image.
enum class TrackState {
  Idle,     ///< not started
  Tracked,  ///< seen in this image, and in the one before
  Refound,  ///< seen in this image again, after it was lost
  Lost,     ///< not seen in this image
};
/// Stable name for files and logs.
std::string_view toString(TrackState state);

/// What becomes of what a tracker sees.
enum class LearningState {
  None,       ///< this kind of tracker learns nothing that can be switched off or saved
  Off,        ///< switched off: the model does not change
  On,         ///< every image that is trusted teaches the model
  Suspended,  ///< switched on, but this image was not trusted: the guard against "explosion"
};
/// Stable name for files and logs.
std::string_view toString(LearningState state);

/// Where the target is in one image.
struct Track {
  TrackState state = TrackState::Idle;
  std::optional<cv::Rect2d> box;  ///< pixels of that image; set if and only if it is seen
  double confidence = 0.0;        ///< 0..1, how sure `box` is; 0 without one
  LearningState learning = LearningState::None;

  static Track idle() { return {}; }
  static Track lost() { return {TrackState::Lost, std::nullopt, 0.0, LearningState::None}; }
};

/// Follows one target, the tool, through the images of one camera (docs/method.md section 3).
///
/// Images are CV_8UC1 or CV_8UC3 (BGR). Used by one thread.
class Tracker {
 public:
  /// Narrower or lower than this, a box holds nothing that could be followed. Pixels.
  static constexpr double minSide = 8.0;

  virtual ~Tracker() = default;

  /// Begins anew with the target in `box` of `image`. Throws Error, and stays as it was, when the
  /// box is empty, not finite, smaller than minSide or reaches outside the image, or when
  /// there is nothing in it to follow.
  virtual void start(const cv::Mat& image, const cv::Rect2d& box) = 0;

  /// Begins anew with what was learnt before; the target is looked for in the whole of the next
  /// image. Throws Error where this kind of tracker has no model.
  virtual void start(const ToolModel& model);

  /// Never throws on what an image holds: an empty or black one, or one of another size or type
  /// than the one before, means Lost (or Idle before start). After a change of size the target is
  /// looked for again, where the tracker can.
  virtual Track track(const cv::Mat& image) = 0;

  /// What was seen in the last image is not the target, as somebody else knows. From the next image
  /// on it is looked for again, where the tracker can; else it stays lost until it is started anew.
  /// Has no effect on a tracker that is never wrong or cannot be told.
  virtual void reject() {}
  /// Whether it has lost the target for good: only start() helps.
  virtual bool hasGivenUp() const { return false; }

  /// Has no effect where nothing is learnt.
  virtual void setLearning(bool /*on*/) {}

  /// What was learnt so far; null where this kind of tracker has no model, or before start.
  virtual std::shared_ptr<const ToolModel> model() const { return nullptr; }
};

/// Whether `image` can be looked at: not empty, CV_8UC1 or CV_8UC3.
bool isTrackable(const cv::Mat& image);

/// Throws Error when `image` or `box` cannot begin a track (see Tracker::start).
void requireStart(const cv::Mat& image, const cv::Rect2d& box);

/// `image` as CV_8UC1; shares its pixels where it is that already.
cv::Mat greyOf(const cv::Mat& image);

}  // namespace boomwatch
