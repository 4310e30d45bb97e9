#include "tracking/keypoint_features.h"

#include <algorithm>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "tracking/cmt_tuning.h"

namespace boomwatch {
namespace {

constexpr CmtTuning tuning;

/// The `kept` strongest of every cell of a grid over `part`; of no place outside it.
void keepStrongest(std::vector<cv::KeyPoint>& points, const cv::Rect2d& part, cv::Size grid,
                   int kept, std::vector<cv::KeyPoint>& result) {
  std::vector<int> taken(static_cast<std::size_t>(grid.area()), 0);
  for (const cv::KeyPoint& point : points) {
    const cv::Point2d at(point.pt);
    if (!part.contains(at)) continue;
    const int column = std::min(int((at.x - part.x) / part.width * grid.width), grid.width - 1);
    const int row = std::min(int((at.y - part.y) / part.height * grid.height), grid.height - 1);
    int& count = taken[static_cast<std::size_t>(row * grid.width + column)];
    if (++count <= kept) result.push_back(point);
  }
}

std::vector<cv::KeyPoint> cornersIn(const cv::Mat& image, double size) {
  cv::Mat small = image;
  if (size > 1.0) cv::resize(image, small, {}, 1.0 / size, 1.0 / size, cv::INTER_AREA);
  std::vector<cv::KeyPoint> points;
  cv::FAST(small, points, tuning.cornerThreshold);
  for (cv::KeyPoint& point : points) {
    // Pixel centres, not corners, keep their place.
    point.pt = (point.pt + cv::Point2f(0.5F, 0.5F)) * size - cv::Point2f(0.5F, 0.5F);
    point.size *= static_cast<float>(size);
  }
  std::ranges::sort(points, std::greater(), &cv::KeyPoint::response);
  return points;
}

/// The pixels that corners in `part`, and what surrounds these, are made of.
cv::Rect around(const cv::Rect2d& part, cv::Size image) {
  const cv::Rect2d grown(part.x - tuning.border, part.y - tuning.border,
                         part.width + 2 * tuning.border, part.height + 2 * tuning.border);
  const cv::Rect2d seen = grown & cv::Rect2d({}, cv::Size2d(image));
  return {cv::Point(cvFloor(seen.x), cvFloor(seen.y)),
          cv::Point(cvFloor(seen.br().x), cvFloor(seen.br().y))};
}

/// Its tables take 50 MB, and as long to make as several images. Nothing changes them afterwards.
cv::BRISK& descriptor() {
  static const cv::Ptr<cv::BRISK> instance = cv::BRISK::create();
  return *instance;
}

}  // namespace

KeypointFeatures keypointsOf(const cv::Mat& grey, const cv::Rect2d& dense, KeypointReach reach) {
  const bool everywhere = reach == KeypointReach::Everywhere;
  cv::Mat image;
  cv::equalizeHist(grey, image);
  const cv::Rect area = everywhere ? cv::Rect({}, image.size()) : around(dense, image.size());
  if (area.empty()) return {};
  image = image(area);
  const cv::Rect2d whole({}, cv::Size2d(image.size()));
  const cv::Rect2d part = (dense - cv::Point2d(area.tl())) & whole;
  std::vector<cv::KeyPoint> points;
  for (const double size : tuning.sizes) {
    if (image.cols < 8 * size || image.rows < 8 * size) continue;
    std::vector<cv::KeyPoint> found = cornersIn(image, size);
    if (!part.empty()) {
      keepStrongest(found, part, {tuning.denseCells, tuning.denseCells}, tuning.keptInDenseCell,
                    points);
      std::erase_if(found, [&](const auto& point) { return part.contains(cv::Point2d(point.pt)); });
    }
    if (everywhere)
      keepStrongest(found, whole, {tuning.cellsAcross, tuning.cellsDown}, tuning.keptInCell,
                    points);
  }
  cv::Mat padded;
  cv::copyMakeBorder(image, padded, tuning.border, tuning.border, tuning.border, tuning.border,
                     cv::BORDER_REPLICATE);
  const cv::Point2f offset(tuning.border, tuning.border);
  for (cv::KeyPoint& point : points) point.pt += offset;
  KeypointFeatures features;
  descriptor().compute(padded, points, features.descriptors);
  const cv::Point2f origin(area.tl());
  for (const cv::KeyPoint& point : points) {
    features.positions.emplace_back(point.pt - offset + origin);
  }
  return features;
}

}  // namespace boomwatch
