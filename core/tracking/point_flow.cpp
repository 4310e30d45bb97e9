#include "tracking/point_flow.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace boomwatch {
namespace {

constexpr int pyramidLevels = 4;
// What the search for a point can reach over all levels, and the box's own size, must be inside.
constexpr double margin = 64.0;  // pixels
const cv::Size patchSize(11, 11);

}  // namespace

cv::Rect flowRegion(const cv::Rect2d& box, cv::Size image) {
  const double reach = std::max({box.width, box.height, margin});
  const cv::Rect2d grown(box.x - reach, box.y - reach, box.width + 2 * reach,
                         box.height + 2 * reach);
  const cv::Rect2d part = grown & cv::Rect2d(0, 0, image.width, image.height);
  return {cv::Point(static_cast<int>(part.x), static_cast<int>(part.y)),
          cv::Point(static_cast<int>(part.br().x), static_cast<int>(part.br().y))};
}

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
