#include "tracking/scan_levels.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tracking/picture_halves.h"
#include "tracking/tld_tuning.h"

namespace boomwatch {
namespace {

constexpr TldTuning tuning;

}  // namespace

ScanLevels::ScanLevels(const cv::Mat& grey, cv::Size2d tool, cv::Size patch, int first, int last)
    : m_patch(patch) {
  PictureHalves halves(grey);
  for (int exponent = first; exponent <= last; ++exponent) {
    const cv::Size2d window = tool * std::pow(tuning.scaleStep, exponent);
    if (std::min(window.width, window.height) < tuning.minWindow) continue;
    if (window.width > grey.cols || window.height > grey.rows) break;
    Level level;
    const cv::Size size(std::max(patch.width, cvRound(grey.cols * patch.width / window.width)),
                        std::max(patch.height, cvRound(grey.rows * patch.height / window.height)));
    level.image = halves.resized(size);
    cv::GaussianBlur(level.image, level.image, cv::Size(3, 3), 0.0);
    level.pixel = {static_cast<double>(grey.cols) / size.width,
                   static_cast<double>(grey.rows) / size.height};
    level.window = {level.pixel.width * patch.width, level.pixel.height * patch.height};
    m_levels.push_back(std::move(level));
  }
}

cv::Rect2d ScanLevels::boxOf(const ScanWindow& window) const {
  const Level& level = m_levels[static_cast<std::size_t>(window.level)];
  return {window.corner.x * level.pixel.width, window.corner.y * level.pixel.height,
          level.window.width, level.window.height};
}

cv::Mat ScanLevels::patchOf(const ScanWindow& window) const {
  return m_levels[static_cast<std::size_t>(window.level)].image(cv::Rect(window.corner, m_patch));
}

}  // namespace boomwatch
