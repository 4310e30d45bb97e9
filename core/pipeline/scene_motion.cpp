#include "pipeline/scene_motion.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "base/point_flow.h"

namespace boomwatch {
namespace {

constexpr int width = 400;           ///< pixels to which a picture is scaled down
constexpr int bucket = 25;           ///< side of a square that gives one corner, pixels
constexpr double minTexture = 1e-4;  ///< smaller eigenvalue that noise does not reach
constexpr float stillness = 0.5F;    ///< pixels: compression and exposure stay below
constexpr std::size_t enough = 20;   ///< corners followed, to tell anything

/// Grey and small; empty where the picture cannot be used.
cv::Mat prepared(const cv::Mat& image) {
  cv::Mat grey;
  if (image.empty() || image.dims != 2) return grey;
  if (image.type() == CV_8UC3) {
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  } else if (image.type() == CV_8UC1) {
    grey = image;
  } else {
    return grey;
  }
  const int height = static_cast<int>(static_cast<double>(width) * image.rows / image.cols);
  if (height < bucket || height > 10 * width) return {};
  cv::Mat small;
  cv::resize(grey, small, {width, height}, 0, 0, cv::INTER_AREA);
  return small;
}

/// The strongest corner of every square: a person full of texture has no more votes than the same
/// area of the background.
std::vector<cv::Point2f> spreadCorners(const cv::Mat& grey) {
  cv::Mat strength;
  cv::cornerMinEigenVal(grey, strength, 5);
  std::vector<cv::Point2f> corners;
  for (int y = 0; y + bucket <= grey.rows; y += bucket) {
    for (int x = 0; x + bucket <= grey.cols; x += bucket) {
      double largest = 0.0;
      cv::Point place;
      cv::minMaxLoc(strength({x, y, bucket, bucket}), nullptr, &largest, nullptr, &place);
      if (largest > minTexture) corners.emplace_back(cv::Point2f(place + cv::Point(x, y)));
    }
  }
  return corners;
}

}  // namespace

std::optional<double> SceneMotion::shareMoved(const cv::Mat& image) {
  const cv::Mat before = m_previous;
  m_previous = prepared(image);
  if (before.empty() || before.size() != m_previous.size()) return std::nullopt;
  const std::vector<cv::Point2f> corners = spreadCorners(before);
  if (corners.size() < enough) return std::nullopt;

  std::size_t followed = 0;
  std::size_t moved = 0;
  for (const FollowedPoint& point : followPoints(before, m_previous, corners, {})) {
    if (static_cast<float>(point.error) > stillness) continue;
    const cv::Point2f step = point.position - corners[point.index];
    ++followed;
    if (std::hypot(step.x, step.y) > stillness) ++moved;
  }
  if (followed < enough) return std::nullopt;
  return static_cast<double>(moved) / static_cast<double>(followed);
}

void SceneMotion::reset() { m_previous.release(); }

}  // namespace boomwatch
