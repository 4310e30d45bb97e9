#include "tracking/median_flow.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/median.h"
#include "tracking/box_flow.h"
#include "tracking/flow_tuning.h"

namespace boomwatch {
namespace {

constexpr FlowTuning tuning;

constexpr int gridSide = FlowCells::side;
const cv::Size window(tuning.window, tuning.window);
const cv::Size patchSize(tuning.patch, tuning.patch);

/// A point in both images.
struct Match {
  std::size_t cell = 0;  ///< of the grid
  cv::Point2f before, after;
  double error = 0.0;       ///< forward-backward, pixels
  double similarity = 0.0;  ///< NCC
};

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
  for (const FollowedPoint& point : followInside(before, after, points, window)) {
    matches.push_back({point.index, points[point.index], point.position, point.error, 0.0});
  }
  return matches;
}

/// NCC, -1..1, of what surrounds a point in one image and one in another.
double patchSimilarity(const cv::Mat& before, cv::Point2f point, const cv::Mat& after,
                       cv::Point2f other) {
  cv::Mat a, b, ncc;
  cv::getRectSubPix(before, patchSize, point, a);
  cv::getRectSubPix(after, patchSize, other, b);
  cv::matchTemplate(a, b, ncc, cv::TM_CCOEFF_NORMED);
  return ncc.at<float>(0);
}

/// Leaves the half for which `worth` is greater, and every one that is equal to its median.
template <class Worth>
void keepBetterHalf(std::vector<Match>& matches, Worth worth) {
  std::vector<double> values;
  for (const Match& match : matches) values.push_back(worth(match));
  const double limit = medianOf(values);
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
  return medianOf(ratios);
}

MedianFlow flowOf(const std::vector<Match>& matches, const cv::Rect2d& box) {
  std::vector<double> x, y, residuals, similarities;
  for (const Match& match : matches) {
    x.push_back(match.after.x - match.before.x);
    y.push_back(match.after.y - match.before.y);
    similarities.push_back(match.similarity);
  }
  const cv::Point2d motion(medianOf(x), medianOf(y));
  for (const Match& match : matches) {
    residuals.push_back(cv::norm(cv::Point2d(match.after - match.before) - motion));
  }
  const double scale = scaleOf(matches);
  const cv::Point2d centre = (box.tl() + box.br()) * 0.5 + motion;
  const cv::Size2d size = box.size() * scale;
  return {{centre.x - size.width / 2, centre.y - size.height / 2, size.width, size.height},
          medianOf(residuals),
          medianOf(similarities)};
}

/// Which cells went where the box has gone.
void noteDown(const std::vector<Match>& matches, const cv::Rect2d& before, const cv::Rect2d& after,
              FlowCells& cells) {
  const cv::Point2d from = (before.tl() + before.br()) * 0.5, to = (after.tl() + after.br()) * 0.5;
  const double motion = cv::norm(to - from), scale = after.width / before.width;
  if (motion < tuning.clearMotion) return;
  for (const Match& match : matches) {
    const cv::Point2d expected = to + scale * (cv::Point2d(match.before) - from);
    const double apart = cv::norm(cv::Point2d(match.after) - expected);
    cells.note(match.cell, apart < tuning.togetherShare * motion);
  }
}

}  // namespace

void FlowCells::note(std::size_t cell, bool together) {
  m_together[cell] += tuning.cellRate * ((together ? 1.0F : 0.0F) - m_together[cell]);
}

std::array<bool, FlowCells::count> FlowCells::reliable() const {
  std::array<float, count> best = m_together;
  std::ranges::nth_element(best, best.begin() + tuning.minReliable - 1, std::greater());
  const float least = std::min(tuning.mostlyTogether, best[tuning.minReliable - 1]);
  std::array<bool, count> cells{};
  for (std::size_t k = 0; k < count; ++k) cells[k] = m_together[k] >= least;
  return cells;
}

std::optional<MedianFlow> medianFlow(const cv::Mat& before, const cv::Mat& after,
                                     const cv::Rect2d& box, FlowCells* cells) {
  if (before.empty() || before.size() != after.size()) return std::nullopt;
  const cv::Rect part = flowRegion(box, before.size());
  if (part.width < window.width || part.height < window.height) return std::nullopt;
  const cv::Mat partBefore = before(part), partAfter = after(part);
  const cv::Point2d origin(part.tl());
  const std::vector<Match> all = follow(partBefore, partAfter, gridIn(box - origin));
  std::vector<Match> matches = all;
  if (cells) {
    std::erase_if(matches, [reliable = cells->reliable()](const Match& match) {
      return !reliable[match.cell];
    });
  }
  if (matches.size() < tuning.minPoints) return std::nullopt;
  keepBetterHalf(matches, [](const Match& match) { return -match.error; });
  for (Match& match : matches) {
    match.similarity = patchSimilarity(partBefore, match.before, partAfter, match.after);
  }
  keepBetterHalf(matches, [](const Match& match) { return match.similarity; });
  if (matches.size() < tuning.minPoints / 2) return std::nullopt;
  MedianFlow flow = flowOf(matches, box - origin);
  if (cells) noteDown(all, box - origin, flow.box, *cells);
  flow.box += origin;
  return flow;
}

}  // namespace boomwatch
