#include "stereo/disparity_veils.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/bands.h"

namespace boomwatch {

cv::Mat withoutVeils(const cv::Mat& disparity, double steepest) {
  cv::Mat result = disparity.clone();
  const auto limit = static_cast<float>(2.0 * steepest);  // of central differences
  inBands(disparity.rows, [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      const auto* const row = disparity.ptr<float>(v);
      const auto* const above = disparity.ptr<float>(std::max(0, v - 1));
      const auto* const below = disparity.ptr<float>(std::min(disparity.rows - 1, v + 1));
      auto* const out = result.ptr<float>(v);
      for (int u = 1; u + 1 < disparity.cols; ++u) {
        const bool steep =
            std::abs(row[u + 1] - row[u - 1]) > limit || std::abs(below[u] - above[u]) > limit;
        if (steep) out[u] = std::numeric_limits<float>::quiet_NaN();
      }
    }
  });
  return result;
}

}  // namespace boomwatch
