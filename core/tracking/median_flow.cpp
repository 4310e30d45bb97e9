#include "tracking/median_flow.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tracking/point_flow.h"

namespace boomwatch {
namespace {

constexpr int gridSide = 10;
constexpr std::size_t fewestPoints = 6;
// What the search for a point can reach over all levels, and the box's own size, must be inside.
constexpr double margin = 64.0;  // pixels
const cv::Size window(9, 9);

/// A point in both images.
struct Match {
  cv::Point2f before, after;
  double error = 0.0;       ///< forward-backward, pixels
  double similarity = 0.0;  ///< NCC
};

template <class Values>
double median(Values& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<cv::Point2f> gridIn(const cv::Rect2d& box) {
  std::vector<cv::Point2f> points;
  for (int row = 0; row < gridSide; ++row) {
    for (int column = 0; column < gridSide; ++column) {
      points.emplace_back(static_cast<float>(box.x + box.width * (column + 0.5) / gridSide),
                          static_cast<float>(box.y + box.height * (row + 0.5) / gridSide));
    }
  }
  return points;
}

/// The points that can be followed there and back.
std::vector<Match> follow(const cv::Mat& before, const cv::Mat& after,
                          const std::vector<cv::Point2f>& points) {
  std::vector<Match> matches;
  for (const FollowedPoint& point : followPoints(before, after, points, window)) {
    matches.push_back({points[point.index], point.position, point.error, 0.0});
  }
  return matches;
}

/// Leaves the half for which `worth` is greater, and every one that is equal to its median.
template <class Worth>
void keepBetterHalf(std::vector<Match>& matches, Worth worth) {
  std::vector<double> values;
  for (const Match& match : matches) values.push_back(worth(match));
  const double limit = median(values);
  std::erase_if(matches, [&](const Match& match) { return worth(match) < limit; });
}

double scaleOf(const std::vector<Match>& matches) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    for (std::size_t j = i + 1; j < matches.size(); ++j) {
      const double before = cv::norm(matches[i].before - matches[j].before);
      ratios.push_back(cv::norm(matches[i].after - matches[j].after) / before);
    }
  }
  return median(ratios);
}

MedianFlow flowOf(const std::vector<Match>& matches, const cv::Rect2d& box) {
  std::vector<double> x, y, residuals, similarities;
  for (const Match& match : matches) {
    x.push_back(match.after.x - match.before.x);
    y.push_back(match.after.y - match.before.y);
    similarities.push_back(match.similarity);
  }
  const cv::Point2d motion(median(x), median(y));
  for (const Match& match : matches) {
    residuals.push_back(cv::norm(cv::Point2d(match.after - match.before) - motion));
  }
  const double scale = scaleOf(matches);
  const cv::Point2d centre = (box.tl() + box.br()) * 0.5 + motion;
  const cv::Size2d size = box.size() * scale;
  return {{centre.x - size.width / 2, centre.y - size.height / 2, size.width, size.height},
          median(residuals),
          median(similarities)};
}

/// The part of the images that matters: Lucas-Kanade's pyramid of all of it takes longer.
cv::Rect around(const cv::Rect2d& box, cv::Size image) {
  const double reach = std::max({box.width, box.height, margin});
  const cv::Rect2d grown(box.x - reach, box.y - reach, box.width + 2 * reach,
                         box.height + 2 * reach);
  const cv::Rect2d part = grown & cv::Rect2d(0, 0, image.width, image.height);
  return {cv::Point(static_cast<int>(part.x), static_cast<int>(part.y)),
          cv::Point(static_cast<int>(part.br().x), static_cast<int>(part.br().y))};
}

}  // namespace

std::optional<MedianFlow> medianFlow(const cv::Mat& before, const cv::Mat& after,
                                     const cv::Rect2d& box) {
  if (before.empty() || before.size() != after.size()) return std::nullopt;
  const cv::Rect part = around(box, before.size());
  if (part.width < window.width || part.height < window.height) return std::nullopt;
  const cv::Mat partBefore = before(part), partAfter = after(part);
  const cv::Point2d origin(part.tl());
  std::vector<Match> matches = follow(partBefore, partAfter, gridIn(box - origin));
  if (matches.size() < fewestPoints) return std::nullopt;
  keepBetterHalf(matches, [](const Match& match) { return -match.error; });
  for (Match& match : matches) {
    match.similarity = patchSimilarity(partBefore, match.before, partAfter, match.after);
  }
  keepBetterHalf(matches, [](const Match& match) { return match.similarity; });
  if (matches.size() < fewestPoints / 2) return std::nullopt;
  MedianFlow flow = flowOf(matches, box - origin);
  flow.box += origin;
  return flow;
}

}  // namespace boomwatch
