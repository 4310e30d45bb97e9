#include "simulation/yard/depth_cloud.h"

#include <cmath>

namespace boomwatch {

std::shared_ptr<const Cloud> cloudOf(const cv::Mat& depth, const PinholeCamera& camera) {
  auto cloud = std::make_shared<Cloud>();
  cloud->width = depth.cols;
  cloud->height = depth.rows;
  cloud->points.reserve(depth.total());
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const float z = depth.at<float>(v, u);
      cloud->points.push_back(std::isfinite(z) ? Eigen::Vector3f(z * camera.ray(u, v).cast<float>())
                                               : unmeasuredPoint());
    }
  }
  return cloud;
}

void roundToMillimetres(cv::Mat& depth) {
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      float& z = depth.at<float>(v, u);
      z = std::round(z * 1000.0F) / 1000.0F;
    }
  }
}

}  // namespace boomwatch
