#include "stereo/disparity_smoother.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace boomwatch {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
// Neighbours say nearly the same: every third one will do, at a ninth of the work.
constexpr int stride = 3;

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
  const auto most = static_cast<float>(frames);
  const auto enough = std::min(most, static_cast<float>(settled));
  for (int row = 0; row < disparity.rows; ++row) {
    const auto* now = disparity.ptr<float>(row);
    auto* mean = m_mean.ptr<float>(row);
    auto* count = m_frames.ptr<float>(row);
    auto* out = result.ptr<float>(row);
    for (int column = 0; column < disparity.cols; ++column) {
      // False for a NaN on either side: what was not measured begins anew too.
      const bool agrees = std::abs(now[column] - mean[column]) <= jump;
      count[column] = agrees ? std::min(count[column] + 1.0F, most) : 1.0F;
      const float step = (now[column] - mean[column]) / count[column];
      mean[column] = agrees ? mean[column] + step : now[column];
      out[column] = count[column] >= enough ? mean[column] : none;
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
