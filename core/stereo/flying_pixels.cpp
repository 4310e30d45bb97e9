#include "stereo/flying_pixels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/row_bands.h"

namespace boomwatch {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// Slope in pixels per pixel; beside a gap, to the one neighbour with a match. 0 without a
/// neighbour.
float slopeAt(float before, float here, float after) {
  if (!std::isnan(before) && !std::isnan(after)) return std::abs(after - before) / 2.0F;
  const float change = std::isnan(before) ? after - here : here - before;
  return std::isnan(change) ? 0.0F : std::abs(change);
}

/// Slopes above which a disparity is a flying pixel.
struct Limits {
  float always;  ///< in any run
  float focalLength;

  /// In a narrow run. A surface at z, whose normal is at the angle t to the line of sight, has the
  /// slope (B / z) tan t, and B / z is d / f (Eq. 5).
  float inNarrowRun(float disparity) const {
    constexpr float grazing = 7.1F;  // tan 82 degrees
    return std::clamp(grazing * disparity / focalLength, always / 2.0F, always);
  }
};

/// Finds the narrow steep runs along one line of pixels.
class SlopeRun {
 public:
  /// Adds the next pixel. When it ends a narrow run, returns the length of that run, else 0.
  int add(bool isSteep) {
    const int length = isSteep ? 0 : m_length;
    m_length = isSteep ? m_length + 1 : 0;
    return length <= maxNarrow ? length : 0;
  }

 private:
  static constexpr int maxNarrow = 12;  ///< pixels
  int m_length = 0;
};

void acrossRow(const cv::Mat& disparity, int v, const Limits& limits, cv::Mat& result) {
  const auto* const row = disparity.ptr<float>(v);
  auto* const out = result.ptr<float>(v);
  SlopeRun run;
  for (int u = 1; u < disparity.cols; ++u) {
    const bool last = u + 1 == disparity.cols;
    const float slope = last ? 0.0F : slopeAt(row[u - 1], row[u], row[u + 1]);
    if (slope > limits.always) out[u] = none;
    for (int k = run.add(slope > limits.inNarrowRun(row[u])); k > 0; --k) out[u - k] = none;
  }
}

void downColumns(const cv::Mat& disparity, const cv::Range& columns, const Limits& limits,
                 cv::Mat& result) {
  std::vector<SlopeRun> runs(static_cast<std::size_t>(columns.size()));
  for (int v = 1; v < disparity.rows; ++v) {
    const bool last = v + 1 == disparity.rows;
    const auto* const above = disparity.ptr<float>(v - 1);
    const auto* const row = disparity.ptr<float>(v);
    const auto* const below = disparity.ptr<float>(last ? v : v + 1);
    for (int u = columns.start; u < columns.end; ++u) {
      const float slope = last ? 0.0F : slopeAt(above[u], row[u], below[u]);
      if (slope > limits.always) result.at<float>(v, u) = none;
      SlopeRun& run = runs[static_cast<std::size_t>(u - columns.start)];
      for (int k = run.add(slope > limits.inNarrowRun(row[u])); k > 0; --k) {
        result.at<float>(v - k, u) = none;
      }
    }
  }
}

}  // namespace

cv::Mat withoutFlyingPixels(const cv::Mat& disparity, double maxSlope, double focalLength) {
  cv::Mat result = disparity.clone();
  const Limits limits{static_cast<float>(maxSlope), static_cast<float>(focalLength)};
  inBands(disparity.rows, [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) acrossRow(disparity, v, limits, result);
  });
  inBands(disparity.cols,
          [&](const cv::Range& columns) { downColumns(disparity, columns, limits, result); });
  return result;
}

}  // namespace boomwatch
