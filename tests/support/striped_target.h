#pragma once

#include <opencv2/core.hpp>

#include "support/tracked_target.h"

namespace boomwatch::test {

/// A target as a grapple that turns: a narrow part in one colour, with a white ring, above a wide
/// one in another, all with dark stripes that run one way or the other.
struct StripedTarget {
  static constexpr int side = 64;  // pixels
  cv::Scalar above{40, 50, 200};   // BGR; both are equally bright: in grey only the stripes show
  cv::Scalar below{200, 85, 70};
  bool turned = false;

  cv::Mat image(cv::Point corner) const {
    cv::Mat picture = texture({480, 360}, 3.0, 1);
    drawInto(picture, corner);
    return picture;
  }
  void drawInto(cv::Mat& picture, cv::Point corner) const {
    cv::Mat target = picture(cv::Rect(corner, cv::Size(side, side)));
    target.setTo(below);
    target.rowRange(0, side / 2).setTo(cv::Scalar::all(20));
    target(cv::Rect(side / 4, 0, side / 2, side / 2)).setTo(above);
    target(cv::Rect(side / 4, side / 4, side / 2, side / 8)).setTo(cv::Scalar::all(240));
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
