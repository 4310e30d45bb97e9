#include "tracking/tool_point.h"

namespace boomwatch {

std::optional<Eigen::Vector3f> toolPointAt(const Cloud& cloud, cv::Point pixel) {
  if (!cloud.organised() || pixel.y < 0 || pixel.y >= cloud.height || pixel.x < 0) return {};
  for (int column = pixel.x; column < cloud.width; ++column) {
    const Eigen::Vector3f& point = cloud.at(column, pixel.y);
    if (isMeasured(point)) return point;
  }
  return {};
}

}  // namespace boomwatch
