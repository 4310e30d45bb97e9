#include "tracking/tool_detector.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace boomwatch {
namespace {

constexpr std::size_t mostCandidates = 100;
constexpr double strideShare = 0.1;  // of the window, as in the paper
constexpr std::size_t mostDetections = 5;
constexpr double sameOverlap = 0.5;

int strideOf(int side) { return std::max(1, cvRound(strideShare * side)); }

/// Sum over a window from an integral image.
template <class Sum>
double sumIn(const cv::Mat& integral, cv::Point corner, cv::Size size) {
  const Sum* top = integral.ptr<Sum>(corner.y) + corner.x;
  const Sum* bottom = integral.ptr<Sum>(corner.y + size.height) + corner.x;
  return bottom[size.width] - bottom[0] - top[size.width] + top[0];
}

void scanLevel(const ScanLevels& levels, int index, const ToolClassifier& tool,
               std::vector<Candidate>& found) {
  const cv::Mat& image = levels.levels()[static_cast<std::size_t>(index)].image;
  const cv::Size size = levels.patchSize();
  cv::Mat sums, squares;
  cv::integral(image, sums, squares, CV_32S, CV_64F);
  const FernEnsemble::Offsets offsets = tool.ferns().offsetsFor(image);
  const auto area = static_cast<double>(size.area());
  const double least = tool.leastVariance();
  cv::Point corner;
  for (corner.y = 0; corner.y + size.height <= image.rows; corner.y += strideOf(size.height)) {
    for (corner.x = 0; corner.x + size.width <= image.cols; corner.x += strideOf(size.width)) {
      const double mean = sumIn<int>(sums, corner, size) / area;
      if (sumIn<double>(squares, corner, size) / area - mean * mean < least) continue;
      const float share = tool.ferns().of(image.ptr(corner.y) + corner.x, offsets, fernThreshold);
      if (share < fernThreshold) continue;
      const ScanWindow window{index, corner};
      found.push_back({levels.boxOf(window), window, share, {}});
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
  if (found.size() > mostCandidates) found.resize(mostCandidates);
  for (Candidate& candidate : found) {
    candidate.likeness = tool.likeness(levels.patchOf(candidate.window));
  }
  return found;
}

std::vector<Detection> clusterDetections(const std::vector<Candidate>& candidates) {
  std::vector<Candidate> left;
  std::ranges::copy_if(candidates, std::back_inserter(left), [](const Candidate& candidate) {
    return candidate.likeness.relative >= toolThreshold;
  });
  std::ranges::stable_sort(left, std::greater(),
                           [](const Candidate& candidate) { return candidate.likeness.relative; });
  std::vector<Detection> detections;
  while (!left.empty() && detections.size() < mostDetections) {
    const Candidate best = left.front();
    cv::Rect2d sum;
    double weights = 0.0;
    std::erase_if(left, [&](const Candidate& candidate) {
      if (overlap(candidate.box, best.box) < sameOverlap) return false;
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
