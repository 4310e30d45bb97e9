#pragma once

#include <cmath>
#include <memory>
#include <opencv2/core.hpp>

#include "display.h"

/// A made-up scene with known numbers: a floor 6 m ahead with a post on it, seen by a pinhole
/// camera of 768 x 576 pixels, and a load 1.5 m in front of the floor.
namespace boomwatch::testing {

inline constexpr double focal = 600.0;
inline constexpr double centreX = 380.0;
inline constexpr double centreY = 290.0;

/// Depth at a pixel; NaN in a block on the left, where nothing was measured.
inline float depthAt(int column, int row) {
  if (column < 60 && row > 400) return std::nanf("");
  const bool post = column > 500 && column < 560 && row > 150;
  return post ? 4.0F : 6.0F;
}

inline std::shared_ptr<const Cloud> makeCloud(int width = 768, int height = 576) {
  auto cloud = std::make_shared<Cloud>();
  cloud->width = width;
  cloud->height = height;
  cloud->camera = {width, height, focal, focal, centreX, centreY};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const float z = depthAt(column, row);
      const auto x = static_cast<float>((column - centreX) / focal) * z;
      const auto y = static_cast<float>((row - centreY) / focal) * z;
      cloud->points.push_back(std::isnan(z) ? unmeasuredPoint() : Eigen::Vector3f(x, y, z));
    }
  }
  return cloud;
}

inline cv::Mat makeImage(int width = 768, int height = 576) {
  cv::Mat image(height, width, CV_8UC3);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      image.at<cv::Vec3b>(row, column) = {static_cast<uchar>(column % 256),
                                          static_cast<uchar>(row % 256), 90};
    }
  }
  return image;
}

inline std::shared_ptr<EnvironmentModel> makeModel(const Cloud& cloud, const Parameters& p) {
  auto model = std::make_shared<EnvironmentModel>(GridGeometry(p.bounds, p.model.resolution));
  const GridGeometry& geometry = model->geometry();
  for (const auto& point : cloud.points) {
    if (!p.bounds.contains(point)) continue;
    const int column = geometry.columnOf(point.x());
    const int row = geometry.rowOf(point.y());
    if (!geometry.contains(column, row)) continue;
    const std::uint8_t level = geometry.levelOf(point.z());
    const std::uint8_t before = model->levels()[geometry.index(column, row)];
    model->set(column, row, 0.6F, before > 0 ? std::min(before, level) : level);
  }
  return model;
}

/// A result with everything set: 0.70 m, measured, from the load's corner.
inline std::shared_ptr<Result> makeResult() {
  auto result = std::make_shared<Result>();
  auto frame = std::make_shared<Frame>();
  result->cloud = makeCloud();
  result->image = makeImage();
  frame->cloud = result->cloud;
  frame->left = result->image;
  result->frame = frame;
  result->load =
      OrientedBox{{0.4, 0.2, 3.8}, {2.0, 0.4, 0.4}, rotationFromYawPitchRoll(0.2, 0.0, 0.3)};
  result->scene.removed = {{0.4F, 0.2F, 3.7F}, {0.5F, 0.2F, 3.7F}};
  result->tool.pixel = cv::Point(300, 200);
  result->model = makeModel(*result->cloud, result->parameters);
  Nearest nearest;
  nearest.distance = 0.7;
  nearest.onLoad = {1.3, 0.5, 3.6};
  nearest.onEnvironment = {1.0, 1.1, 4.0};
  nearest.part = LoadPart::Corner;
  nearest.quantisation = 0.05;
  result->clearance.state = ClearanceState::Measured;
  result->clearance.reason = Reason::None;
  result->clearance.nearest = nearest;
  result->clearance.observedShare = 0.834;
  result->level = WarningLevel::Warning;
  return result;
}

}  // namespace boomwatch::testing
