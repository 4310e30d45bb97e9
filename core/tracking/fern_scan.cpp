#include "tracking/fern_scan.h"

#include <opencv2/core/hal/intrin.hpp>

namespace boomwatch {
namespace {

/// `count` comparisons in each lane, the first in the highest bit.
cv::v_uint8x16 compared(const uchar* first, const std::array<std::ptrdiff_t, 2>* offsets,
                        std::size_t count) {
  cv::v_uint8x16 bits = cv::v_setzero_u8();
  for (std::size_t i = 0; i < count; ++i) {
    const cv::v_uint8x16 one = cv::v_load(first + offsets[i][0]);
    const cv::v_uint8x16 other = cv::v_load(first + offsets[i][1]);
    // What is true has all bits set, which is -1.
    bits = cv::v_sub_wrap(cv::v_add_wrap(bits, bits), one > other);
  }
  return bits;
}

}  // namespace

FernScan::FernScan(const FernEnsemble& ferns, const cv::Mat& image, int stride) {
  const int columns = (image.cols + stride - 1) / stride;
  // The last windows' lanes read on into what follows.
  m_sorted =
      cv::Mat::zeros(image.rows, stride * columns + static_cast<int>(FernScan::lanes), CV_8UC1);
  for (int row = 0; row < image.rows; ++row) {
    const uchar* from = image.ptr(row);
    for (int phase = 0; phase < stride; ++phase) {
      uchar* to = m_sorted.ptr(row) + static_cast<std::ptrdiff_t>(phase) * columns;
      for (int column = phase; column < image.cols; column += stride) *to++ = from[column];
    }
  }
  const auto offsetOf = [&](cv::Point pixel) {
    return static_cast<std::ptrdiff_t>(pixel.y) * static_cast<std::ptrdiff_t>(m_sorted.step) +
           static_cast<std::ptrdiff_t>(pixel.x % stride) * columns + pixel.x / stride;
  };
  for (const auto& [one, other] : ferns.pairs()) {
    m_offsets.push_back({offsetOf(one), offsetOf(other)});
  }
}

void FernScan::read(int row, int first, Codes& codes) const {
  static_assert(lanes == cv::v_uint8x16::nlanes);
  constexpr std::size_t low = 8, high = FernEnsemble::comparisons - low;
  const uchar* window = m_sorted.ptr(row) + first;
  for (std::size_t fern = 0; fern < FernEnsemble::ferns; ++fern) {
    const auto* offsets = &m_offsets[fern * FernEnsemble::comparisons];
    std::array<uchar, lanes> upper{}, lower{};
    cv::v_store(upper.data(), compared(window, offsets, high));
    cv::v_store(lower.data(), compared(window, offsets + high, low));
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      codes[lane][fern] = static_cast<std::uint16_t>(upper[lane] << low | lower[lane]);
    }
  }
}

}  // namespace boomwatch
