#include "patch_strip.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace boomwatch {
namespace {

constexpr int gap = 2;
constexpr int pitch = patchSide + gap;

/// The newest first, into row `row` of `strip`.
void drawRow(const std::vector<cv::Mat>& patches, int row, cv::Mat& strip) {
  const int count = std::min(static_cast<int>(patches.size()), patchesInRow);
  for (int k = 0; k < count; ++k) {
    const cv::Mat& patch = patches[patches.size() - 1 - static_cast<std::size_t>(k)];
    if (patch.empty() || patch.type() != CV_8UC1) continue;
    const double scale = static_cast<double>(patchSide) / std::max(patch.cols, patch.rows);
    const cv::Size size(std::max(1, cvRound(patch.cols * scale)),
                        std::max(1, cvRound(patch.rows * scale)));
    cv::Mat place = strip(cv::Rect({k * pitch, row * pitch}, size));
    cv::resize(patch, place, size, 0.0, 0.0, cv::INTER_NEAREST);
  }
}

}  // namespace

QImage patchStrip(const ToolModel& model) {
  if (model.positives.empty() && model.negatives.empty()) return {};
  cv::Mat strip = cv::Mat::zeros(2 * pitch - gap, patchesInRow * pitch - gap, CV_8UC1);
  drawRow(model.positives, 0, strip);
  drawRow(model.negatives, 1, strip);
  return QImage(strip.data, strip.cols, strip.rows, static_cast<qsizetype>(strip.step),
                QImage::Format_Grayscale8)
      .copy();
}

}  // namespace boomwatch
