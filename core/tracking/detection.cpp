#include "tracking/detection.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "tracking/fern_scan.h"
#include "tracking/tld_tuning.h"

namespace boomwatch {
namespace {

constexpr TldTuning tuning;

int strideOf(int side) { return std::max(1, cvRound(tuning.strideShare * side)); }

/// Sum over a window from an integral image.
template <class Sum>
double sumIn(const cv::Mat& integral, cv::Point corner, cv::Size size) {
  const Sum* top = integral.ptr<Sum>(corner.y) + corner.x;
  const Sum* bottom = integral.ptr<Sum>(corner.y + size.height) + corner.x;
  return bottom[size.width] - bottom[0] - top[size.width] + top[0];
}

/// Which windows of a level have enough variance to be asked about.
class VarianceFilter {
 public:
  VarianceFilter(const cv::Mat& image, cv::Size size, double least)
      : m_size(size), m_area(size.area()), m_least(least) {
    cv::integral(image, m_sums, m_squares, CV_32S, CV_64F);
  }

  bool passes(cv::Point corner) const {
    const double mean = sumIn<int>(m_sums, corner, m_size) / m_area;
    return sumIn<double>(m_squares, corner, m_size) / m_area - mean * mean >= m_least;
  }

 private:
  cv::Size m_size;
  double m_area, m_least;
  cv::Mat m_sums, m_squares;
};

void scanLevel(const ScanLevels& levels, int index, const ToolClassifier& tool,
               std::vector<Candidate>& found) {
  const cv::Mat& image = levels.levels()[static_cast<std::size_t>(index)].image;
  const cv::Size size = levels.patchSize();
  const cv::Size stride(strideOf(size.width), strideOf(size.height));
  const VarianceFilter variance(image, size, tool.minVariance());
  const FernScan scan(tool.ferns(), image, stride.width);
  constexpr int lanes = static_cast<int>(FernScan::lanes);
  const int windows = (image.cols - size.width) / stride.width + 1;
  FernScan::Codes codes;
  for (int row = 0; row + size.height <= image.rows; row += stride.height) {
    for (int first = 0; first < windows; first += lanes) {
      bool isRead = false;
      for (int window = first; window < std::min(first + lanes, windows); ++window) {
        const cv::Point corner(window * stride.width, row);
        if (!variance.passes(corner)) continue;
        if (!isRead) scan.read(row, first, codes);
        isRead = true;
        const float share = tool.ferns().toolShare(codes[static_cast<std::size_t>(window - first)],
                                                   tuning.fernThreshold);
        if (share < tuning.fernThreshold) continue;
        const ScanWindow place{index, corner};
        found.push_back({levels.boxOf(place), place, share, {}});
      }
    }
  }
}

}  // namespace

double overlap(const cv::Rect2d& one, const cv::Rect2d& other) {
  const double common = (one & other).area();
  return common > 0.0 ? common / (one.area() + other.area() - common) : 0.0;
}

std::vector<Candidate> findCandidates(const ScanLevels& levels, const ToolClassifier& tool) {
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < levels.levels().size(); ++i) {
    scanLevel(levels, static_cast<int>(i), tool, found);
  }
  std::ranges::stable_sort(found, std::greater(), &Candidate::share);
  if (found.size() > tuning.maxCandidates) found.resize(tuning.maxCandidates);
  for (Candidate& candidate : found) {
    candidate.likeness = tool.likeness(levels.patchOf(candidate.window));
  }
  return found;
}

std::vector<Detection> clusterDetections(const std::vector<Candidate>& candidates) {
  std::vector<Candidate> left;
  std::ranges::copy_if(candidates, std::back_inserter(left), [](const Candidate& candidate) {
    return candidate.likeness.relative >= tuning.toolThreshold;
  });
  std::ranges::stable_sort(left, std::greater(),
                           [](const Candidate& candidate) { return candidate.likeness.relative; });
  std::vector<Detection> detections;
  while (!left.empty() && detections.size() < tuning.maxDetections) {
    const Candidate best = left.front();
    cv::Rect2d sum;
    double weights = 0.0;
    std::erase_if(left, [&](const Candidate& candidate) {
      if (overlap(candidate.box, best.box) < tuning.sameOverlap) return false;
      sum.x += candidate.box.x;
      sum.y += candidate.box.y;
      sum.width += candidate.box.width;
      sum.height += candidate.box.height;
      weights += 1.0;
      return true;
    });
    const cv::Rect2d mean(sum.x / weights, sum.y / weights, sum.width / weights,
                          sum.height / weights);
    detections.push_back({mean, best.likeness});
  }
  return detections;
}

}  // namespace boomwatch
