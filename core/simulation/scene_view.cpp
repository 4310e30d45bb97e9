#include "simulation/scene_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/yard/dice.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

/// -1..1, the same all over each 5 cm cube of space: texture that stays on the surface.
double textureAt(const Vector3d& p) {
  std::uint64_t hash = 0;
  for (const double coordinate : p) {
    // The small shift keeps surfaces at round coordinates from flickering between two cubes.
    hash = mixed(hash ^ static_cast<std::uint64_t>(std::lround((coordinate + 0.0127) / 0.05)));
  }
  return static_cast<double>(hash & 0xffff) / 32767.5 - 1.0;
}

std::uint8_t shade(const Vector3d& p, const Vector3d& normal) {
  const Vector3d light = Vector3d(-0.4, -0.8, -0.5).normalized();
  const double lit = 70.0 + 110.0 * std::max(0.0, normal.dot(light));
  return static_cast<std::uint8_t>(std::clamp(lit + 25.0 * textureAt(p), 0.0, 255.0));
}

constexpr std::uint8_t sky = 210;

/// The pixels in which a box can be; all of them when it reaches behind the camera.
cv::Rect pixelsAround(const OrientedBox& box, const PinholeCamera& camera) {
  const cv::Rect all(0, 0, camera.width, camera.height);
  double left = std::numeric_limits<double>::infinity(), top = left;
  double right = -left, bottom = -left;
  for (const Vector3d& corner : box.corners()) {
    if (corner.z() < 0.01) return all;
    const Eigen::Vector2d pixel = camera.project(corner);
    left = std::min(left, pixel.x()), right = std::max(right, pixel.x());
    top = std::min(top, pixel.y()), bottom = std::max(bottom, pixel.y());
  }
  const auto column = [&](double u) {
    return static_cast<int>(std::clamp(u, -1.0, camera.width + 1.0));
  };
  const auto row = [&](double v) {
    return static_cast<int>(std::clamp(v, -1.0, camera.height + 1.0));
  };
  return cv::Rect(cv::Point(column(left), row(top)),
                  cv::Point(column(right) + 2, row(bottom) + 2)) &
         all;
}

void addNoise(cv::Mat& image, std::uint64_t sequence) {
  std::uint64_t state = mixed(sequence + 1);
  for (int row = 0; row < image.rows; ++row) {
    auto* pixel = image.ptr<std::uint8_t>(row);
    for (int column = 0; column < image.cols; ++column) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      const int noisy = pixel[column] + static_cast<int>((state >> 33) % 5) - 2;
      pixel[column] = static_cast<std::uint8_t>(std::clamp(noisy, 0, 255));
    }
  }
}

}  // namespace

SceneView lookAt(const Scene& scene, const PinholeCamera& camera) {
  auto cloud = std::make_shared<Cloud>();
  cloud->width = camera.width;
  cloud->height = camera.height;
  cloud->camera = camera;
  cloud->points.reserve(static_cast<std::size_t>(camera.width) *
                        static_cast<std::size_t>(camera.height));
  cv::Mat image(camera.height, camera.width, CV_8UC1, cv::Scalar(sky));
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Vector3d ray = camera.ray(u, v);
      const auto hit = cast(scene, Vector3d::Zero(), ray);
      if (!hit || hit->depth > SceneView::farthest) {
        cloud->points.push_back(unmeasuredPoint());
        continue;
      }
      const Vector3d p = hit->depth * ray;
      cloud->points.push_back(p.cast<float>());
      image.at<std::uint8_t>(v, u) = shade(p, hit->normal);
    }
  }
  return {std::move(cloud), image};
}

cv::Mat pictureWithLoad(const SceneView& view, const OrientedBox& load, std::uint64_t sequence) {
  cv::Mat picture = view.image.clone();
  const PinholeCamera& camera = *view.cloud->camera;
  const cv::Rect pixels = pixelsAround(load, camera);
  for (int v = pixels.y; v < pixels.y + pixels.height; ++v) {
    for (int u = pixels.x; u < pixels.x + pixels.width; ++u) {
      const Vector3d ray = camera.ray(u, v);
      const auto hit = cast(load, Vector3d::Zero(), ray);
      const Eigen::Vector3f& behind = view.cloud->at(u, v);
      if (!hit || (isMeasured(behind) && hit->depth > static_cast<double>(behind.z()))) continue;
      // The texture moves with the load.
      const Vector3d local = load.rotation.transpose() * (hit->depth * ray - load.centre);
      picture.at<std::uint8_t>(v, u) = shade(local, hit->normal);
    }
  }
  addNoise(picture, sequence);
  return picture;
}

}  // namespace boomwatch
