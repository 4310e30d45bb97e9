#pragma once

#include <map>
#include <memory>
#include <string>

#include "simulation/yard/yard_source.h"

/// Frames of demo:yard; each yard is planted once, which takes a second.
class YardFrames {
 public:
  boomwatch::FramePtr at(const std::string& options, std::size_t index) {
    return withTruth(options, index).frame;
  }
  boomwatch::YardFrame withTruth(const std::string& options, std::size_t index) {
    auto& source = m_sources[options];
    if (!source) source = std::make_unique<boomwatch::YardSource>(options);
    return source->at(index);
  }

 private:
  std::map<std::string, std::unique_ptr<boomwatch::YardSource>> m_sources;
};

inline bool samePicture(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}
