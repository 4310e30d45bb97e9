#pragma once

#include <map>
#include <memory>
#include <string>

#include "simulation/demo_source.h"
#include "simulation/yard/yard_truth.h"

/// Frames of demo:yard; each yard is planted once, which takes a second.
class YardFrames {
 public:
  boomwatch::FramePtr at(const std::string& options, std::size_t index) {
    auto& source = m_sources[options];
    const std::string name = options.empty() ? "yard" : "yard," + options;
    if (!source) source = boomwatch::openDemoSource(name, "demo:" + name);
    return source->seek(index) ? source->next(std::chrono::milliseconds(0)).frame : nullptr;
  }

 private:
  std::map<std::string, std::unique_ptr<boomwatch::FrameSource>> m_sources;
};

inline bool samePicture(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}
