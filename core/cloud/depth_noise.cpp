#include "cloud/depth_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "base/median.h"
#include "base/row_bands.h"

namespace boomwatch {
namespace {

/// Below this (9 mm at 10 m) there is nothing to take out.
constexpr double noNoise = 9e-5;

bool isOrganised(const Cloud& cloud) { return cloud.width > 2 && cloud.height > 1; }

/// 1/z; NaN where nothing was measured.
cv::Mat inverseDepths(const Cloud& cloud) {
  cv::Mat inverse(cloud.height, cloud.width, CV_32FC1);
  for (int v = 0; v < inverse.rows; ++v) {
    auto* const row = inverse.ptr<float>(v);
    for (int u = 0; u < inverse.cols; ++u) {
      const float z = cloud.at(u, v).z();
      row[u] = z > 0.0F && std::isfinite(z) ? 1.0F / z : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return inverse;
}

std::optional<double> noiseOf(const cv::Mat& inverse) {
  constexpr int rowsApart = 5;
  constexpr std::size_t enough = 500;
  std::vector<float> differences;
  for (int v = 0; v < inverse.rows; v += rowsApart) {
    const auto* const row = inverse.ptr<float>(v);
    for (int u = 1; u + 1 < inverse.cols; u += 2) {
      const float second = std::abs(row[u - 1] - 2.0F * row[u] + row[u + 1]);
      if (!std::isnan(second)) differences.push_back(second);
    }
  }
  if (differences.size() < enough) return std::nullopt;
  // A normal variable's median size is 0.6745 of its deviation; 1, -2, 1 has that of the square
  // root of 6.
  return static_cast<double>(medianOf(differences)) / (0.6745 * std::sqrt(6.0));
}

/// The mean of a row's pixels and of those around them that are less than `alike` apart. As many on
/// one side as on the other, at the picture's border too, or slopes would be bent there.
[[gnu::always_inline]] inline void smoothRow(const cv::Mat& inverse, int v, int reach, float alike,
                                             std::vector<float>& sums, std::vector<float>& counts) {
  const auto* const centre = inverse.ptr<float>(v);
  std::fill(sums.begin(), sums.end(), 0.0F);
  std::fill(counts.begin(), counts.end(), 0.0F);
  const int down = std::min({reach, v, inverse.rows - 1 - v});
  for (int dv = -down; dv <= down; ++dv) {
    const auto* const other = inverse.ptr<float>(v + dv);
    for (int du = -reach; du <= reach; ++du) {
      const int begin = std::abs(du), end = inverse.cols - begin;
      float* const sum = sums.data();
      float* const count = counts.data();
      const float* const there = other + du;
      // A loop each: in one the compiler branches on what is alike, and does one pixel at a time.
      // Nothing is alike if either is NaN.
      for (int u = begin; u < end; ++u) {
        sum[u] += std::abs(there[u] - centre[u]) < alike ? there[u] : 0.0F;
      }
      for (int u = begin; u < end; ++u) {
        count[u] += std::abs(there[u] - centre[u]) < alike ? 1.0F : 0.0F;
      }
    }
  }
}

#ifdef __x86_64__
/// Half of the time, and the same to the last bit.
[[gnu::target("avx2")]] void smoothRowByAvx2(const cv::Mat& inverse, int v, int reach, float alike,
                                             std::vector<float>& sums, std::vector<float>& counts) {
  smoothRow(inverse, v, reach, alike, sums, counts);
}
#endif

void smoothed(const cv::Mat& inverse, int v, int reach, float alike, std::vector<float>& sums,
              std::vector<float>& counts) {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) {
    return smoothRowByAvx2(inverse, v, reach, alike, sums, counts);
  }
#endif
  smoothRow(inverse, v, reach, alike, sums, counts);
}

}  // namespace

std::optional<double> depthNoise(const Cloud& cloud) {
  if (!isOrganised(cloud)) return std::nullopt;
  return noiseOf(inverseDepths(cloud));
}

std::shared_ptr<const Cloud> withoutDepthNoise(const std::shared_ptr<const Cloud>& cloud,
                                               int window) {
  if (!isOrganised(*cloud) || window < 3) return cloud;
  const cv::Mat inverse = inverseDepths(*cloud);
  const auto noise = noiseOf(inverse);
  if (!noise || *noise < noNoise) return cloud;
  // Two points of one surface differ by the root of 2 of the noise; four times that hardly ever.
  const auto alike = static_cast<float>(4.0 * std::sqrt(2.0) * *noise);
  auto smooth = std::make_shared<Cloud>(*cloud);
  inBands(inverse.rows, [&](const cv::Range& rows) {
    std::vector<float> sums(static_cast<std::size_t>(inverse.cols)), counts(sums.size());
    for (int v = rows.start; v < rows.end; ++v) {
      smoothed(inverse, v, window / 2, alike, sums, counts);
      const auto* const centre = inverse.ptr<float>(v);
      auto* const points = &smooth->points[static_cast<std::size_t>(v) * sums.size()];
      for (std::size_t u = 0; u < sums.size(); ++u) {
        if (counts[u] > 0.0F) points[u] *= centre[u] * counts[u] / sums[u];
      }
    }
  });
  return smooth;
}

}  // namespace boomwatch
