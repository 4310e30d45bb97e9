#include "tracking/box_flow.h"

#include <algorithm>

#include "tracking/flow_tuning.h"

namespace boomwatch {
namespace {

constexpr FlowTuning tuning;

}  // namespace

cv::Rect flowRegion(const cv::Rect2d& box, cv::Size image) {
  const double reach = std::max({box.width, box.height, tuning.minMargin});
  const cv::Rect2d grown(box.x - reach, box.y - reach, box.width + 2 * reach,
                         box.height + 2 * reach);
  const cv::Rect2d part = grown & cv::Rect2d(0, 0, image.width, image.height);
  return {cv::Point(static_cast<int>(part.x), static_cast<int>(part.y)),
          cv::Point(static_cast<int>(part.br().x), static_cast<int>(part.br().y))};
}

std::vector<FollowedPoint> followInside(const cv::Mat& before, const cv::Mat& after,
                                        const std::vector<cv::Point2f>& points, cv::Size window) {
  std::vector<FollowedPoint> followed =
      followPoints(before, after, points, {.window = window, .levels = tuning.pyramidLevels});
  const cv::Rect2f inside({}, cv::Size2f(after.size()));
  std::erase_if(followed, [&](const auto& point) { return !inside.contains(point.position); });
  return followed;
}

}  // namespace boomwatch
