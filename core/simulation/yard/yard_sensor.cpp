#include "simulation/yard/yard_sensor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "simulation/yard/dice.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr std::size_t noiseSamples = 1 << 17;

/// Numbers of mean 0 and deviation 1 (Box and Muller, who make two at a time).
class Gaussian {
 public:
  explicit Gaussian(Dice dice) : m_dice(dice) {}

  double next() {
    m_hasSecond = !m_hasSecond;
    if (!m_hasSecond) return m_second;
    const double radius = std::sqrt(-2.0 * std::log(1.0 - m_dice.uniform(0.0, 1.0)));
    const double angle = 2.0 * std::numbers::pi * m_dice.uniform(0.0, 1.0);
    m_second = radius * std::sin(angle);
    return radius * std::cos(angle);
  }

 private:
  Dice m_dice;
  bool m_hasSecond = false;
  double m_second = 0.0;
};

std::uint64_t streamOf(const YardEye& eye, std::size_t frame) {
  return 2 * static_cast<std::uint64_t>(frame) + (eye.eye.x() > 0.0 ? 1 : 0);
}

}  // namespace

YardSensor::YardSensor(const YardOptions& options) : m_options(options) {
  if (options.noise <= 0.0) return;
  m_noise.resize(noiseSamples);
  Gaussian gaussian(Dice(options.seed, 31));
  for (std::int8_t& sample : m_noise) {
    const double value = std::clamp(options.noise * gaussian.next(), -127.0, 127.0);
    sample = static_cast<std::int8_t>(std::lround(value));
  }
}

/// Clouds pass: a slow swing with a faster one on it.
double YardSensor::gainAt(std::size_t frame) const {
  const double time = static_cast<double>(frame) / 20.0;
  const double phase = Dice(m_options.seed, 32).uniform(0.0, 6.28);
  const double swing = 0.75 * std::sin(2.0 * std::numbers::pi * time / 9.0 + phase) +
                       0.25 * std::sin(2.0 * std::numbers::pi * time / 2.3 + 2.0 * phase);
  return std::exp2(m_options.exposure * swing);
}

void YardSensor::addRain(cv::Mat& colour, const YardEye& eye, std::size_t frame) const {
  const auto drops = static_cast<int>(1500.0 * m_options.rain);
  const Vector3d fall = eye.level.transpose() * Vector3d(0.05, 0.16, 0.0);
  cv::Mat streaks(colour.size(), CV_8UC1, cv::Scalar(0));
  Dice dice(m_options.seed, 40000 + frame);  // both eyes see the same drops
  const PinholeCamera& camera = eye.camera;
  constexpr int fraction = 4;
  const auto pixel = [&](const Vector3d& point) {
    const Vector3d p = point - eye.eye;
    const double scale = camera.fx / p.z();
    return cv::Point(static_cast<int>(std::lround((scale * p.x() + camera.cx) * (1 << fraction))),
                     static_cast<int>(std::lround((scale * p.y() + camera.cy) * (1 << fraction))));
  };
  for (int k = 0; k < drops; ++k) {
    // As many drops in every piece of the pyramid that is seen.
    const double z = 0.8 + 8.0 * std::cbrt(dice.uniform(0.0, 1.0));
    const Vector3d drop(dice.uniform(-0.72, 0.72) * z, dice.uniform(-0.60, 0.55) * z, z);
    const int thickness = z < 1.5 ? 2 : 1;
    cv::line(streaks, pixel(drop), pixel(drop + fall), cv::Scalar(40.0 + 130.0 / z), thickness,
             cv::LINE_AA, fraction);
  }
  const int haze = static_cast<int>(45.0 * m_options.rain);
  for (int v = 0; v < colour.rows; ++v) {
    const auto* streak = streaks.ptr<std::uint8_t>(v);
    auto* row = colour.ptr<std::uint8_t>(v);
    for (int k = 0; k < 3 * colour.cols; ++k) {
      const int part = std::max<int>(streak[k / 3], haze);
      row[k] = static_cast<std::uint8_t>(row[k] + (205 - row[k]) * part / 255);
    }
  }
}

void YardSensor::addNoise(cv::Mat& colour, std::uint64_t stream) const {
  Dice dice(m_options.seed, 7000000 + stream);
  const int width = 3 * colour.cols;
  for (int v = 0; v < colour.rows; ++v) {
    const auto start = dice.bits() % (noiseSamples - static_cast<std::size_t>(width));
    const std::int8_t* noise = m_noise.data() + start;
    auto* row = colour.ptr<std::uint8_t>(v);
    for (int k = 0; k < width; ++k) {
      row[k] = static_cast<std::uint8_t>(std::clamp(row[k] + noise[k], 0, 255));
    }
  }
}

void YardSensor::expose(cv::Mat& colour, const YardEye& eye, std::size_t frame) const {
  if (m_options.rain > 0.0) addRain(colour, eye, frame);
  cv::GaussianBlur(colour, colour, {3, 3}, 0.55);
  if (m_options.exposure > 0.0) colour.convertTo(colour, -1, gainAt(frame));
  if (!m_noise.empty()) addNoise(colour, streamOf(eye, frame));
}

void addDepthNoise(cv::Mat& depth, double noise, double depthTimesDisparity, std::uint64_t stream) {
  Gaussian gaussian(Dice(stream, 33));
  for (int v = 0; v < depth.rows; ++v) {
    auto* row = depth.ptr<float>(v);
    for (int u = 0; u < depth.cols; ++u) {
      const double z = static_cast<double>(row[u]);
      if (!std::isfinite(z)) continue;
      const double disparity = depthTimesDisparity / z + noise * gaussian.next();
      row[u] = disparity > 0.0 ? static_cast<float>(depthTimesDisparity / disparity)
                               : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

}  // namespace boomwatch
