#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "tracking/fern_ensemble.h"

namespace boomwatch {

/// Reads the codes of an ensemble's ferns at windows that lie side by side in an image, many at a
/// time: nearly all that TLD's detector does is this.
class FernScan {
 public:
  /// Windows read together.
  static constexpr std::size_t lanes = 16;
  /// For each of them what FernEnsemble::codesOf() gives.
  using Codes = std::array<FernEnsemble::Codes, lanes>;

  /// `image`: CV_8UC1. The windows' left edges are `stride` pixels apart.
  FernScan(const FernEnsemble& ferns, const cv::Mat& image, int stride);

  /// Of the windows whose upper edge is `row`, from the one `first` strides from the left edge,
  /// which must lie inside the image. What is given for those that reach out of it on the right
  /// means nothing.
  void read(int row, int first, Codes& codes) const;

 private:
  /// Of each of the image's rows first the columns 0, stride, 2 stride ..., then 1, stride + 1 ...:
  /// pixels that belong to the same place of neighbouring windows lie beside each other.
  cv::Mat m_sorted;
  std::vector<std::array<std::ptrdiff_t, 2>> m_offsets;  ///< in m_sorted, as FernEnsemble::pairs()
};

}  // namespace boomwatch
