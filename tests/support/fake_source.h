#pragma once

#include <functional>
#include <memory>
#include <opencv2/core.hpp>

#include "sources/frame_source.h"

namespace boomwatch::test {

/// A wall 3 m away as a small organised cloud, a load in front of it, and a picture that differs
/// from frame to frame.
inline FramePtr wallFrame(std::size_t index, double stamp) {
  constexpr int width = 64;
  constexpr int height = 48;
  auto cloud = std::make_shared<Cloud>();
  cloud->width = width;
  cloud->height = height;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      cloud->points.emplace_back(static_cast<float>((u - 32) * 0.05),
                                 static_cast<float>((v - 24) * 0.05), 3.0F);
    }
  }
  auto frame = std::make_shared<Frame>();
  frame->sequence = index;
  frame->stamp = stamp;
  frame->left = cv::Mat(height, width, CV_8UC1);
  cv::RNG random(index + 1);
  random.fill(frame->left, cv::RNG::UNIFORM, 0, 255);
  frame->cloud = cloud;
  frame->load = OrientedBox{{0, 0, 1.5}, {1, 0.4, 0.4}, Eigen::Matrix3d::Identity()};
  return frame;
}

/// What happens at each read, said beforehand.
struct Script {
  SourceInfo info{"fake", 10, 10.0, false};
  /// What frame `index` is; a good one where it is not set.
  std::function<ReadResult(std::size_t)> read;
  std::function<double(std::size_t)> stamp = [](std::size_t index) { return 0.1 * index; };
};

class FakeSource : public FrameSource {
 public:
  explicit FakeSource(Script script) : m_script(std::move(script)) {}

  SourceInfo info() const override { return m_script.info; }
  bool seek(std::size_t index) override {
    if (m_script.info.live || index >= m_script.info.frameCount.value_or(0)) return false;
    m_next = index;
    return true;
  }
  ReadResult next(std::chrono::milliseconds) override {
    if (m_script.info.frameCount && m_next >= *m_script.info.frameCount) return {};
    const std::size_t index = m_next++;
    if (m_script.read) return m_script.read(index);
    return {ReadResult::Status::Ok, wallFrame(index, m_script.stamp(index)), {}, 0};
  }

 private:
  Script m_script;
  std::size_t m_next = 0;
};

}  // namespace boomwatch::test
