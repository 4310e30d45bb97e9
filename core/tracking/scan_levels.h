#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace boomwatch {

/// One place where the tool is looked for: a patch-sized window of one level.
struct ScanWindow {
  int level = 0;
  cv::Point corner;  ///< pixels of the level's picture
};

/// The picture at many scales, such that the tool, if it were of that scale, is as large as the
/// patches of its model: every scanning window is a plain rectangle of patchSize pixels.
class ScanLevels {
 public:
  /// `tool`: its size in the picture at scale 1, pixels. `grey` is CV_8UC1. Levels run from
  /// scaleStep^first to scaleStep^last (see TldTuning), as far as windows fit the picture and are
  /// not tiny.
  ScanLevels(const cv::Mat& grey, cv::Size2d tool, cv::Size patch, int first, int last);

  struct Level {
    cv::Mat image;      ///< CV_8UC1, smoothed
    cv::Size2d window;  ///< of the tool at this scale, pixels of the picture
    cv::Size2d pixel;   ///< of one of the level's pixels, pixels of the picture
  };
  const std::vector<Level>& levels() const { return m_levels; }
  cv::Size patchSize() const { return m_patch; }

  /// Pixels of the picture.
  cv::Rect2d boxOf(const ScanWindow& window) const;
  /// The window's pixels; shares them.
  cv::Mat patchOf(const ScanWindow& window) const;

 private:
  cv::Size m_patch;
  std::vector<Level> m_levels;
};

}  // namespace boomwatch
