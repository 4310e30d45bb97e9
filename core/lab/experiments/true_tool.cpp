#include "lab/experiments/true_tool.h"

#include <algorithm>

namespace boomwatch {
namespace {

class TrueTracker : public Tracker {
 public:
  explicit TrueTracker(std::shared_ptr<const std::optional<cv::Rect2d>> box)
      : m_box(std::move(box)) {}

  using Tracker::start;
  void start(const cv::Mat&, const cv::Rect2d&) override {}
  Track track(const cv::Mat&) override {
    if (!*m_box) return Track::lost();
    return {TrackState::Tracked, *m_box, 1.0, LearningState::None};
  }

 private:
  std::shared_ptr<const std::optional<cv::Rect2d>> m_box;
};

}  // namespace

TrackerMaker TrueTool::maker() const {
  return [box = m_box](TrackerKind) { return std::make_unique<TrueTracker>(box); };
}

std::optional<cv::Rect2d> toolBoxIn(const YardFrame& shown, double share) {
  const Frame& frame = *shown.frame;
  if (!frame.tool || shown.truth->toolVisible < share) return std::nullopt;
  const cv::Rect2d inside = *frame.tool & cv::Rect2d({}, cv::Size2d(frame.left.size()));
  const bool large = std::min(inside.width, inside.height) >= Tracker::minSide;
  return large ? std::optional(inside) : std::nullopt;
}

}  // namespace boomwatch
