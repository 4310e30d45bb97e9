#include "lab/experiments/model_picture.h"

#include <opencv2/imgproc.hpp>

namespace boomwatch {
namespace {

constexpr std::uint8_t freeGrey = 40;

std::uint8_t stripes(int column, int row) { return (column + row) % 6 < 2 ? 96 : 0; }

template <class Grey>
cv::Mat picture(const EnvironmentModel& model, Grey grey) {
  const GridGeometry& geometry = model.geometry();
  cv::Mat image(geometry.rows(), geometry.columns(), CV_8UC1);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const bool never = model.state(column, row) == CellState::NeverObserved;
      image.at<std::uint8_t>(row, column) =
          never ? stripes(column, row) : grey(geometry.index(column, row));
    }
  }
  return image;
}

}  // namespace

cv::Mat modelPicture(const EnvironmentModel& model) {
  return picture(model, [&](std::size_t k) -> std::uint8_t {
    const int level = model.levels()[k];
    return level == 0 ? freeGrey : static_cast<std::uint8_t>(255 - level * 3 / 4);
  });
}

cv::Mat probabilityPicture(const EnvironmentModel& model) {
  return picture(model, [&](std::size_t k) {
    const double share = std::min(1.0, static_cast<double>(model.probabilities()[k]));
    return static_cast<std::uint8_t>(freeGrey + share * (255 - freeGrey));
  });
}

cv::Mat enlarged(const cv::Mat& picture, int times) {
  cv::Mat large;
  cv::resize(picture, large, {}, times, times, cv::INTER_NEAREST);
  return large;
}

cv::Mat besideEachOther(const cv::Mat& left, const cv::Mat& right) {
  constexpr int gap = 12;
  cv::Mat both(std::max(left.rows, right.rows), left.cols + gap + right.cols, CV_8UC1,
               cv::Scalar(255));
  left.copyTo(both(cv::Rect({0, 0}, left.size())));
  right.copyTo(both(cv::Rect({left.cols + gap, 0}, right.size())));
  return both;
}

}  // namespace boomwatch
