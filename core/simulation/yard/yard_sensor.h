#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "simulation/yard/yard_eye.h"
#include "simulation/yard/yard_options.h"

namespace boomwatch {

/// Makes of a clean picture what a camera gives: rain before it, exposure, lens, noise. Pure.
class YardSensor {
 public:
  explicit YardSensor(const YardOptions& options);

  /// Changes the picture (CV_8UC3) that `eye` took as number `frame`.
  void expose(cv::Mat& colour, const YardEye& eye, std::size_t frame) const;

 private:
  void addRain(cv::Mat& colour, const YardEye& eye, std::size_t frame) const;
  void addNoise(cv::Mat& colour, std::uint64_t stream) const;
  double gainAt(std::size_t frame) const;

  YardOptions m_options;
  std::vector<std::int8_t> m_noise;  ///< samples; rows begin anywhere in them
};

/// What a sensor measures of exact depths (CV_32FC1, NaN where there is none): `noise` pixels of
/// disparity, so that the error grows with the depth squared. Pure.
void addDepthNoise(cv::Mat& depth, double noise, double depthTimesDisparity, std::uint64_t stream);

}  // namespace boomwatch
