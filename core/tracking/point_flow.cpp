#include "tracking/point_flow.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace boomwatch {
namespace {

constexpr int pyramidLevels = 4;
const cv::Size patchSize(11, 11);

}  // namespace

std::vector<FollowedPoint> followPoints(const cv::Mat& before, const cv::Mat& after,
                                        const std::vector<cv::Point2f>& points, cv::Size window) {
  if (points.empty()) return {};
  std::vector<cv::Mat> pyramidBefore, pyramidAfter;
  const int levels = cv::buildOpticalFlowPyramid(before, pyramidBefore, window, pyramidLevels);
  cv::buildOpticalFlowPyramid(after, pyramidAfter, window, pyramidLevels);
  std::vector<cv::Point2f> there, back;
  std::vector<unsigned char> foundThere, foundBack;
  cv::calcOpticalFlowPyrLK(pyramidBefore, pyramidAfter, points, there, foundThere, cv::noArray(),
                           window, levels);
  cv::calcOpticalFlowPyrLK(pyramidAfter, pyramidBefore, there, back, foundBack, cv::noArray(),
                           window, levels);
  const cv::Rect2f inside({}, cv::Size2f(after.size()));
  std::vector<FollowedPoint> followed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!foundThere[i] || !foundBack[i] || !inside.contains(there[i])) continue;
    followed.push_back({i, there[i], cv::norm(back[i] - points[i])});
  }
  return followed;
}

double patchSimilarity(const cv::Mat& before, cv::Point2f point, const cv::Mat& after,
                       cv::Point2f other) {
  cv::Mat a, b, ncc;
  cv::getRectSubPix(before, patchSize, point, a);
  cv::getRectSubPix(after, patchSize, other, b);
  cv::matchTemplate(a, b, ncc, cv::TM_CCOEFF_NORMED);
  return ncc.at<float>(0);
}

}  // namespace boomwatch
