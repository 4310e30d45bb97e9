#pragma once

#include <opencv2/imgproc.hpp>

#include "tracked_target.h"

namespace boomwatch::test {

/// A target in two colours, one above the other, with dark stripes that run one way or the other:
/// as a grapple that turns.
struct StripedTarget {
  static constexpr int side = 64;  // pixels
  cv::Scalar above{40, 50, 200};   // BGR; both are equally bright: in grey only the stripes show
  cv::Scalar below{200, 85, 70};
  bool turned = false;

  cv::Mat image(cv::Point corner) const {
    cv::Mat picture = texture({480, 360}, 3.0, 1);
    if (picture.channels() == 1) cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
    drawInto(picture, corner);
    return picture;
  }
  void drawInto(cv::Mat& picture, cv::Point corner) const {
    cv::Mat target = picture(cv::Rect(corner, cv::Size(side, side)));
    target.rowRange(0, side / 2).setTo(above);
    target.rowRange(side / 2, side).setTo(below);
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        const int along = turned ? 2 * column - row + side : 2 * row + column;
        if (along % 12 < 4) target.at<cv::Vec3b>(row, column) = {20, 20, 20};
      }
    }
  }
  static cv::Rect2d box(cv::Point corner) { return {cv::Point2d(corner), cv::Size2d(side, side)}; }
};

}  // namespace boomwatch::test
