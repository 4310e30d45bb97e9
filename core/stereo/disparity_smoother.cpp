#include "stereo/disparity_smoother.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace boomwatch {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
// Neighbours say nearly the same: every fifth one will do, at a fraction of the work.
constexpr int stride = 5;

/// Adds the neighbours `shift` columns away that are like the centre. NaN fails the comparison.
void addAlike(const float* centre, const float* neighbours, int shift, int columns, float* sum,
              float* count) {
  const int begin = std::max(0, -shift), end = std::min(columns, columns - shift);
  for (int column = begin; column < end; ++column) {
    const float there = neighbours[column + shift];
    const bool alike = std::abs(there - centre[column]) < DisparitySmoother::alike;
    sum[column] += alike ? there : 0.0F;
    count[column] += alike ? 1.0F : 0.0F;
  }
}

void smoothRow(const cv::Mat& from, int row, int reach, cv::Mat& to, std::vector<float>& scratch) {
  const int columns = from.cols;
  scratch.assign(2 * static_cast<std::size_t>(columns), 0.0F);
  float* const sum = scratch.data();
  float* const count = sum + columns;
  const auto* centre = from.ptr<float>(row);
  for (int dy = -reach; dy <= reach; dy += stride) {
    if (row + dy < 0 || row + dy >= from.rows) continue;
    for (int dx = -reach; dx <= reach; dx += stride) {
      addAlike(centre, from.ptr<float>(row + dy), dx, columns, sum, count);
    }
  }
  auto* out = to.ptr<float>(row);
  for (int column = 0; column < columns; ++column) {
    out[column] = count[column] > 0.0F ? sum[column] / count[column] : none;
  }
}

cv::Mat smoothOnce(const cv::Mat& disparity, int window) {
  cv::Mat result(disparity.size(), CV_32FC1);
  // A multiple of the stride, so that the centre is among its own neighbours.
  const int reach = std::max(stride, window / 2 / stride * stride);
  cv::parallel_for_({0, disparity.rows}, [&](const cv::Range& rows) {
    std::vector<float> scratch;
    for (int row = rows.start; row < rows.end; ++row) {
      smoothRow(disparity, row, reach, result, scratch);
    }
  });
  return result;
}

/// One pixel. `count`: frames in a row that agree with `mean`, or, below 0, frames without a match.
float takeIn(float now, float& mean, float& count, float frames) {
  const float enough = std::min(frames, static_cast<float>(DisparitySmoother::settled));
  if (std::isnan(now)) {
    count = std::min(count, 0.0F) - 1.0F;
    if (count < -frames) mean = none;
    return none;
  }
  const float change = now - mean;
  if (std::abs(change) <= DisparitySmoother::jump) {
    count = std::min(std::max(count, 0.0F) + 1.0F, frames);
    mean += change / count;
  } else {
    // A NaN: nothing is known that it could be noise of.
    const bool atOnce = std::isnan(change) || change > DisparitySmoother::clearlyNearer;
    count = atOnce ? enough : 1.0F;
    mean = now;
  }
  return count >= enough ? mean : none;
}

}  // namespace

cv::Mat DisparitySmoother::overTime(const cv::Mat& disparity, int frames) {
  if (frames <= 1) {
    reset();
    return disparity;
  }
  if (m_mean.size() != disparity.size()) {
    m_mean = cv::Mat(disparity.size(), CV_32FC1, cv::Scalar(none));
    m_frames = cv::Mat(disparity.size(), CV_32FC1, cv::Scalar(0));
  }
  cv::Mat result(disparity.size(), CV_32FC1);
  for (int row = 0; row < disparity.rows; ++row) {
    const auto* now = disparity.ptr<float>(row);
    auto* mean = m_mean.ptr<float>(row);
    auto* count = m_frames.ptr<float>(row);
    auto* out = result.ptr<float>(row);
    for (int column = 0; column < disparity.cols; ++column) {
      out[column] = takeIn(now[column], mean[column], count[column], static_cast<float>(frames));
    }
  }
  return result;
}

void DisparitySmoother::reset() { m_mean = m_frames = cv::Mat(); }

cv::Mat DisparitySmoother::overSpace(const cv::Mat& disparity, int window) {
  if (window < 2) return disparity;
  // Twice: the first time a noisy centre still chooses noisy neighbours.
  return smoothOnce(smoothOnce(disparity, window), window);
}

}  // namespace boomwatch
