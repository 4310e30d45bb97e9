#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "simulation/yard/yard_source.h"

/// Frames of demo:yard; each yard is planted once, which takes a second. The first frames that are
/// asked for are kept, for drawing one takes longer than most of what is tested with it.
class YardFrames {
 public:
  /// A frame takes some 10 MB.
  explicit YardFrames(std::size_t maxKept = 12) : m_maxKept(maxKept) {}

  boomwatch::FramePtr at(const std::string& options, std::size_t index) {
    return withTruth(options, index).frame;
  }
  boomwatch::YardFrame withTruth(const std::string& options, std::size_t index) {
    const auto kept = m_kept.find({options, index});
    if (kept != m_kept.end()) return kept->second;
    auto& source = m_sources[options];
    if (!source) source = std::make_unique<boomwatch::YardSource>(options);
    const boomwatch::YardFrame frame = source->at(index);
    if (m_kept.size() < m_maxKept) m_kept[{options, index}] = frame;
    return frame;
  }

 private:
  std::size_t m_maxKept;
  std::map<std::pair<std::string, std::size_t>, boomwatch::YardFrame> m_kept;
  std::map<std::string, std::unique_ptr<boomwatch::YardSource>> m_sources;
};

inline bool samePicture(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}
