#include "simulation/yard/depth_cloud.h"

#include <cmath>
#include <vector>

namespace boomwatch {

std::shared_ptr<const Cloud> cloudOf(const cv::Mat& depth, const PinholeCamera& camera) {
  auto cloud = std::make_shared<Cloud>();
  cloud->width = depth.cols;
  cloud->height = depth.rows;
  cloud->camera = camera;
  cloud->points.resize(depth.total());
  std::vector<float> across;  // the ray of each column: no division a pixel
  for (int u = 0; u < depth.cols; ++u) {
    across.push_back(static_cast<float>(camera.ray(u, 0).x()));
  }
  auto point = cloud->points.begin();
  for (int v = 0; v < depth.rows; ++v) {
    const auto down = static_cast<float>(camera.ray(0, v).y());
    const auto* row = depth.ptr<float>(v);
    for (const float x : across) {
      const float z = *row++;
      *point++ = std::isfinite(z) ? Eigen::Vector3f(z * x, z * down, z) : unmeasuredPoint();
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
