#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace boomwatch {

/// Cuts patches of a model's size out of one picture around one box: as it is, or turned, shifted
/// and scaled a little, as training needs it. The patches are as sharp as those of ScanLevels.
class PatchCutter {
 public:
  /// `grey` is CV_8UC1; `box` may reach outside, where the border's pixels are repeated.
  PatchCutter(const cv::Mat& grey, const cv::Rect2d& box, cv::Size patch);

  struct Warp {
    double angle = 0.0;  ///< radians
    double scale = 1.0;  ///< of what is seen
    cv::Point2d shift;   ///< in boxes
  };
  cv::Mat cut(const Warp& warp) const;
  cv::Mat cut() const { return cut(Warp()); }

 private:
  cv::Size m_patch;
  cv::Mat m_around;
  cv::Point2d m_centre;  ///< of the box, pixels of m_around
};

/// A patch's pixels with mean 0 and length 1, so that a product of two is their correlation; zeros
/// where all pixels are equal.
Eigen::VectorXf normalised(const cv::Mat& patch);

/// Variance of the pixels.
double varianceOf(const cv::Mat& patch);

}  // namespace boomwatch
