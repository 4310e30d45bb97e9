#include "base/point_flow.h"

#include <opencv2/video/tracking.hpp>

namespace boomwatch {

std::vector<FollowedPoint> followPoints(const cv::Mat& before, const cv::Mat& after,
                                        const std::vector<cv::Point2f>& points,
                                        const FlowSearch& search,
                                        const std::vector<cv::Point2f>& guess) {
  if (points.empty()) return {};
  const cv::Size window = search.window;
  std::vector<cv::Mat> pyramidBefore, pyramidAfter;
  const int levels = cv::buildOpticalFlowPyramid(before, pyramidBefore, window, search.levels);
  cv::buildOpticalFlowPyramid(after, pyramidAfter, window, search.levels);
  std::vector<cv::Point2f> there = guess, back = points;
  std::vector<unsigned char> foundThere, foundBack;
  const int begin = guess.empty() ? 0 : cv::OPTFLOW_USE_INITIAL_FLOW;
  cv::calcOpticalFlowPyrLK(pyramidBefore, pyramidAfter, points, there, foundThere, cv::noArray(),
                           window, levels, search.end, begin);
  cv::calcOpticalFlowPyrLK(pyramidAfter, pyramidBefore, there, back, foundBack, cv::noArray(),
                           window, levels, search.end, begin);
  std::vector<FollowedPoint> followed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!foundThere[i] || !foundBack[i]) continue;
    followed.push_back({i, there[i], cv::norm(back[i] - points[i])});
  }
  return followed;
}

}  // namespace boomwatch
