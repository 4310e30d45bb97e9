#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace boomwatch::test {

/// Noise with structure of `grain` pixels, the same in every run: something that can be followed.
inline cv::Mat texture(cv::Size size, double grain, unsigned seed) {
  cv::Mat noise(size, CV_8UC3);
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(noise, noise, {}, grain);
  cv::normalize(noise, noise, 0, 255, cv::NORM_MINMAX);
  return noise;
}

/// A textured square that moves, turns and grows before a textured wall.
class TargetScene {
 public:
  static constexpr int side = 80;  // pixels at scale 1

  /// Pixels: how coarse the structure is.
  explicit TargetScene(double wallGrain = 3.0, double targetGrain = 1.5)
      : m_wall(texture({320, 240}, wallGrain, 1)),
        m_target(texture({side, side}, targetGrain, 2)) {}

  /// Centre in pixels, angle in degrees.
  cv::Mat image(cv::Point2d centre, double angle = 0.0, double scale = 1.0) const {
    cv::Mat picture = m_wall.clone();
    // Pixel (side - 1) / 2 of the target is its centre.
    const double middle = (side - 1) / 2.0;
    cv::Mat turn = cv::getRotationMatrix2D(cv::Point2f(float(middle), float(middle)), angle, scale);
    turn.at<double>(0, 2) += centre.x - middle;
    turn.at<double>(1, 2) += centre.y - middle;
    cv::Mat shown, mask;
    cv::warpAffine(m_target, shown, turn, picture.size());
    cv::warpAffine(cv::Mat(m_target.size(), CV_8UC1, cv::Scalar(255)), mask, turn, picture.size());
    shown.copyTo(picture, mask > 127);
    return picture;
  }
  /// Of the upright target.
  static cv::Rect2d box(cv::Point2d centre, double scale = 1.0) {
    const double size = side * scale;
    return {centre.x - size / 2, centre.y - size / 2, size, size};
  }
  const cv::Mat& wall() const { return m_wall; }

 private:
  cv::Mat m_wall, m_target;
};

}  // namespace boomwatch::test
