#include "tracking/tool_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace boomwatch {
namespace {

/// Of row `row`, columns `first` to `end`.
std::optional<Eigen::Vector3f> firstMeasured(const Cloud& cloud, int row, int first, int end) {
  if (!cloud.organised() || row < 0 || row >= cloud.height || first < 0) return {};
  for (int column = first; column < std::min(end, cloud.width); ++column) {
    const Eigen::Vector3f& point = cloud.at(column, row);
    if (isMeasured(point)) return point;
  }
  return {};
}

std::optional<Eigen::Vector3f> nearPoint(const Cloud& cloud, const cv::Rect2d& box) {
  if (!cloud.organised()) return {};
  const cv::Rect middle = cv::Rect(cv::Rect2d(box.x + box.width / 4, box.y + box.height / 4,
                                              box.width / 2 + 1, box.height / 2 + 1)) &
                          cv::Rect(0, 0, cloud.width, cloud.height);
  Points points;
  for (int row = middle.y; row < middle.y + middle.height; ++row) {
    for (int column = middle.x; column < middle.x + middle.width; ++column) {
      if (isMeasured(cloud.at(column, row))) points.push_back(cloud.at(column, row));
    }
  }
  if (points.empty()) return {};
  const auto quartile = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 4);
  std::nth_element(points.begin(), quartile, points.end(),
                   [](const auto& a, const auto& b) { return a.z() < b.z(); });
  return *quartile;
}

}  // namespace

std::optional<Eigen::Vector3f> toolPointAt(const Cloud& cloud, cv::Point pixel) {
  return firstMeasured(cloud, pixel.y, pixel.x, cloud.width);
}

cv::Point centreOf(const cv::Rect2d& box) {
  return {cvFloor(box.x + box.width / 2), cvFloor(box.y + box.height / 2)};
}

std::optional<Eigen::Vector3f> toolPointIn(const Cloud& cloud, const cv::Rect2d& box,
                                           ToolPointRule rule) {
  if (rule == ToolPointRule::Near) return nearPoint(cloud, box);
  const cv::Point centre = centreOf(box);
  return firstMeasured(cloud, centre.y, centre.x, cvCeil(box.x + box.width));
}

}  // namespace boomwatch
