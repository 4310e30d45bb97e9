#pragma once

#include <memory>
#include <opencv2/imgproc.hpp>

#include "frame/frame.h"
#include "parameters/parameters.h"

namespace boomwatch::test {

/// Bounds of 4 m x 4 m x 5 m and cells of 5 cm.
inline Parameters smallParameters() {
  Parameters parameters;
  parameters.bounds = {-2.0, 2.0, -2.0, 2.0, 0.0, 5.0};
  parameters.model.resolution = 0.05;
  parameters.filter.clusterMinimum = 1;
  return parameters;
}

/// A box hung level at (0, 0, z).
inline void hangLoad(Parameters& parameters, double z, double size = 0.4) {
  parameters.load.source = LoadSource::Manual;
  parameters.load.x = parameters.load.y = 0.0;
  parameters.load.z = z;
  parameters.load.sizeX = parameters.load.sizeY = parameters.load.sizeZ = size;
}

/// A wall across the view at `z`, seen by a camera of 160 x 160 pixels with f = 80 px: it sees the
/// whole of the small bounds at 2 m and beyond, a point every 2.5 cm there.
inline std::shared_ptr<Cloud> wallCloud(float z) {
  auto cloud = std::make_shared<Cloud>();
  cloud->width = cloud->height = 160;
  cloud->camera = PinholeCamera::centred(160, 160, 80.0);
  for (int row = 0; row < 160; ++row) {
    for (int column = 0; column < 160; ++column) {
      cloud->points.emplace_back((static_cast<float>(column) - 79.5F) * z / 80.0F,
                                 (static_cast<float>(row) - 79.5F) * z / 80.0F, z);
    }
  }
  return cloud;
}

/// A picture full of corners, shifted by (dx, dy) pixels; the same seed gives the same picture.
inline cv::Mat texture(cv::Size size, int dx = 0, int dy = 0, std::uint64_t seed = 1) {
  cv::RNG random(seed);
  cv::Mat coarse(size.height / 8 + 8, size.width / 8 + 8, CV_8UC1);
  random.fill(coarse, cv::RNG::UNIFORM, 0, 255);
  cv::Mat fine;
  cv::resize(coarse, fine, {}, 8, 8, cv::INTER_NEAREST);
  return fine(cv::Rect(16 + dx, 16 + dy, size.width, size.height)).clone();
}

/// Frame `sequence` of a still wall. Sensor noise of a grey level keeps pictures from being equal.
inline FramePtr wallFrame(std::uint64_t sequence, float z, int shift = 0) {
  auto frame = std::make_shared<Frame>();
  frame->sequence = sequence;
  frame->stamp = static_cast<double>(sequence) * 0.05;
  frame->cloud = wallCloud(z);
  frame->left = texture({160, 160}, shift);
  cv::RNG noise(sequence + 17);
  frame->left.at<std::uint8_t>(noise.uniform(0, 160), noise.uniform(0, 160)) ^= 1;
  return frame;
}

}  // namespace boomwatch::test
