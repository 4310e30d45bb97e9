#include "stereo/disparity_smoother.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/row_bands.h"

namespace boomwatch {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
// Only every fifth neighbour is used: adjacent pixels are nearly equal.
constexpr int stride = 5;

/// Sums over the neighbours of each pixel of a row.
struct Neighbours {
  float* sum;    ///< of the disparities within `alike`
  float* alike;  ///< their count, the pixel included
  float* close;  ///< count of those within `jump`
};

/// Adds the neighbours `shift` columns away. NaN fails the comparisons.
[[gnu::always_inline]] inline void addNeighbours(const float* centre, const float* neighbours,
                                                 int shift, int columns, const Neighbours& to) {
  const int begin = std::max(0, -shift), end = std::min(columns, columns - shift);
  const float* const there = neighbours + shift;
  // Three loops, because the compiler does not vectorise one loop with all three sums.
  float* const sum = to.sum;
  for (int column = begin; column < end; ++column) {
    const float apart = std::abs(there[column] - centre[column]);
    sum[column] += apart < DisparitySmoother::alike ? there[column] : 0.0F;
  }
  float* const alike = to.alike;
  for (int column = begin; column < end; ++column) {
    const float apart = std::abs(there[column] - centre[column]);
    alike[column] += apart < DisparitySmoother::alike ? 1.0F : 0.0F;
  }
  float* const close = to.close;
  for (int column = begin; column < end; ++column) {
    const float apart = std::abs(there[column] - centre[column]);
    close[column] += apart < DisparitySmoother::jump ? 1.0F : 0.0F;
  }
}

[[gnu::always_inline]] inline void addAll(const cv::Mat& from, int row, int reach,
                                          const Neighbours& to) {
  for (int dy = -reach; dy <= reach; dy += stride) {
    if (row + dy < 0 || row + dy >= from.rows) continue;
    for (int dx = -reach; dx <= reach; dx += stride) {
      addNeighbours(from.ptr<float>(row), from.ptr<float>(row + dy), dx, from.cols, to);
    }
  }
}

#ifdef __x86_64__
[[gnu::target("avx2")]] void addAllByAvx2(const cv::Mat& from, int row, int reach,
                                          const Neighbours& to) {
  addAll(from, row, reach, to);
}
#endif

void addAround(const cv::Mat& from, int row, int reach, const Neighbours& to) {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return addAllByAvx2(from, row, reach, to);
#endif
  addAll(from, row, reach, to);
}

void smoothRow(const cv::Mat& from, int row, int reach, cv::Mat& to, std::vector<float>& scratch) {
  const int columns = from.cols;
  scratch.assign(3 * static_cast<std::size_t>(columns), 0.0F);
  float* const sum = scratch.data();
  const Neighbours around{sum, sum + columns, sum + 2 * columns};
  addAround(from, row, reach, around);
  // Count of neighbours at the corner of a surface. A pixel with so many close neighbours, but less
  // than a quarter of them alike, is noise. On a slope a third is alike.
  const auto corner = static_cast<float>((reach / stride + 1) * (reach / stride + 1));
  auto* out = to.ptr<float>(row);
  for (int column = 0; column < columns; ++column) {
    const float alike = around.alike[column];
    const bool noise = alike < corner / 4.0F && around.close[column] >= corner;
    out[column] = alike > 0.0F && !noise ? sum[column] / alike : none;
  }
}

cv::Mat smoothOnce(const cv::Mat& disparity, int window) {
  cv::Mat result(disparity.size(), CV_32FC1);
  // A multiple of the stride, so that the centre is among its own neighbours.
  const int reach = std::max(stride, window / 2 / stride * stride);
  inBands(disparity.rows, [&](const cv::Range& rows) {
    std::vector<float> scratch;
    for (int row = rows.start; row < rows.end; ++row) {
      smoothRow(disparity, row, reach, result, scratch);
    }
  });
  return result;
}

/// Whether a disparity may be noise of a nearby known surface.
bool mayBeNoiseOf(const cv::Mat& known, int row, int column, float disparity) {
  constexpr int reach = DisparitySmoother::nearby, apart = reach / 3;
  const int right = std::min(column + reach, known.cols - 1);
  for (int y = row - reach; y <= row + reach; y += apart) {
    if (y < 0 || y >= known.rows) continue;
    const auto* there = known.ptr<float>(y);
    for (int x = column < reach ? column % apart : column - reach; x <= right; x += apart) {
      if (std::abs(there[x] - disparity) <= DisparitySmoother::jump) return true;
    }
  }
  return false;
}

float framesToSettle(float frames) {
  return std::min(frames, static_cast<float>(DisparitySmoother::settled));
}

/// Updates one pixel; returns its mean, or NaN until it has settled. `count`: frames in a row that
/// agree with `mean`; below 0, minus the frames without a match.
float addFrame(float now, float& mean, float& count, float frames) {
  const float enough = framesToSettle(frames);
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
    count = change > DisparitySmoother::clearlyNearer ? enough : 1.0F;
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
  // Only old surfaces: the edge of a moving object must not wait for its interior.
  cv::Mat known(disparity.size(), CV_32FC1, cv::Scalar(none));
  m_mean.copyTo(known, m_frames >= frames);
  const float enough = framesToSettle(static_cast<float>(frames));
  for (int row = 0; row < disparity.rows; ++row) {
    const auto* now = disparity.ptr<float>(row);
    auto* mean = m_mean.ptr<float>(row);
    auto* count = m_frames.ptr<float>(row);
    auto* out = result.ptr<float>(row);
    for (int column = 0; column < disparity.cols; ++column) {
      if (std::isnan(mean[column]) && !std::isnan(now[column]) &&
          !mayBeNoiseOf(known, row, column, now[column])) {
        mean[column] = now[column];
        count[column] = enough - 1.0F;
      }
      out[column] = addFrame(now[column], mean[column], count[column], static_cast<float>(frames));
    }
  }
  return result;
}

void DisparitySmoother::reset() { m_mean = m_frames = cv::Mat(); }

cv::Mat DisparitySmoother::overSpace(const cv::Mat& disparity, int window) {
  if (window < 2) return disparity;
  // Twice, because in the first pass a noisy centre selects noisy neighbours.
  return smoothOnce(smoothOnce(disparity, window), window);
}

}  // namespace boomwatch
