#include "tracking/colour_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "tracking/colour_layout_tuning.h"
#include "tracking/detection.h"
#include "tracking/picture_halves.h"

namespace boomwatch {
namespace {

using Place = ColourLayout::Place;
using Views = std::vector<cv::Mat>;

constexpr ColourLayoutTuning tuning;

/// Lab, L 0..100.
cv::Mat labOf(const cv::Mat& image) {
  cv::Mat colours = image, lab;
  if (image.channels() == 1) cv::cvtColor(image, colours, cv::COLOR_GRAY2BGR);
  colours.convertTo(lab, CV_32FC3, 1.0 / 255.0);
  cv::cvtColor(lab, lab, cv::COLOR_BGR2Lab);
  return lab;
}

/// Without its mean colour, and of length 1: a product of two is their correlation. Zeros where all
/// is alike.
cv::Mat unitOf(const cv::Mat& lab) {
  const cv::Mat varying = lab - cv::mean(lab);
  const double length = cv::norm(varying);
  return length > tuning.minDeviation * std::sqrt(lab.total())
             ? cv::Mat(varying / length)
             : cv::Mat::zeros(lab.size(), lab.type());
}

/// Standard deviation of the colours of each window of `cells`, times the root of their number.
cv::Mat lengthsIn(const cv::Mat& lab, cv::Size cells) {
  cv::Mat means, squares, variance;
  cv::boxFilter(lab, means, CV_32F, cells, {0, 0}, true, cv::BORDER_REPLICATE);
  cv::sqrBoxFilter(lab, squares, CV_32F, cells, {0, 0}, true, cv::BORDER_REPLICATE);
  cv::transform(squares - means.mul(means), variance, cv::Matx13f::ones());
  cv::Mat lengths;
  cv::sqrt(cv::max(variance, tuning.minDeviation * tuning.minDeviation) * cells.area(), lengths);
  return lengths;
}

/// Correlation of each window with whichever view is most alike. cv::matchTemplate gives the same,
/// but does it by Fourier transforms, for each view anew: ten times as long for views so small.
cv::Mat scoresIn(const cv::Mat& lab, const Views& views) {
  std::vector<cv::Mat> channels, kernels;
  cv::split(lab, channels);
  cv::Mat best(lab.size(), CV_32FC1, cv::Scalar(-std::numeric_limits<float>::max())), one;
  for (const cv::Mat& view : views) {
    cv::split(view, kernels);
    cv::Mat sum = cv::Mat::zeros(lab.size(), CV_32FC1);
    for (std::size_t k = 0; k < channels.size(); ++k) {
      cv::filter2D(channels[k], one, CV_32F, kernels[k], {0, 0}, 0.0, cv::BORDER_REPLICATE);
      sum += one;
    }
    best = cv::max(best, sum);
  }
  const cv::Size cells = views.front().size();
  const cv::Rect windows(0, 0, lab.cols - cells.width + 1, lab.rows - cells.height + 1);
  return cv::Mat(best / lengthsIn(lab, cells))(windows).clone();
}

/// What is in `box`, in so many cells, beyond the border what is at the border; empty where too
/// little of it is inside.
cv::Mat viewOf(const cv::Mat& image, const cv::Rect2d& box, cv::Size cells) {
  const cv::Rect wanted(box), inside = wanted & cv::Rect({}, image.size());
  if (2 * inside.area() <= wanted.area() || inside.width < cells.width ||
      inside.height < cells.height) {
    return {};
  }
  cv::Mat whole, view;
  cv::copyMakeBorder(image(inside), whole, inside.y - wanted.y, wanted.br().y - inside.br().y,
                     inside.x - wanted.x, wanted.br().x - inside.br().x, cv::BORDER_REPLICATE);
  cv::resize(whole, view, cells, 0.0, 0.0, cv::INTER_AREA);
  return unitOf(labOf(view));
}

/// The best of a level and, with what is around it left out, the next best.
void addPlacesOf(const cv::Mat& level, const Views& views, cv::Size image,
                 std::vector<Place>& found) {
  const cv::Size cells = views.front().size();
  cv::Mat scores = scoresIn(labOf(level), views);
  const double x = static_cast<double>(image.width) / level.cols;
  const double y = static_cast<double>(image.height) / level.rows;
  for (int k = 0; k < tuning.placesOfALevel; ++k) {
    double score = 0.0;
    cv::Point at;
    cv::minMaxLoc(scores, nullptr, &score, nullptr, &at);
    found.push_back({{at.x * x, at.y * y, cells.width * x, cells.height * y}, score});
    const cv::Rect around(at - cv::Point(cells.width / 2, cells.height / 2), cells);
    scores(around & cv::Rect({}, scores.size())).setTo(-1.0);
  }
}

/// `box` shifted by so many of its own sizes and scaled about its centre.
cv::Rect2d moved(const cv::Rect2d& box, cv::Point2d shift, double scale) {
  const cv::Size2d size(box.width * scale, box.height * scale);
  return {box.x + shift.x * box.width + (box.width - size.width) / 2.0,
          box.y + shift.y * box.height + (box.height - size.height) / 2.0, size.width, size.height};
}

/// Also a part of the tool looks a little like it, and is no other place.
bool isSamePlace(const cv::Rect2d& one, const cv::Rect2d& other) {
  return (one & other).area() > tuning.samePlace * std::min(one.area(), other.area());
}

}  // namespace

void ColourLayout::begin(const cv::Mat& image, const cv::Rect2d& box) {
  const double cell = std::max(box.width, box.height) / tuning.cellsOfLongSide;
  m_cells = {std::max(tuning.minCells, cvRound(box.width / cell)),
             std::max(tuning.minCells, cvRound(box.height / cell))};
  m_size = box.size();
  m_views.clear();
  m_observed.clear();
  cv::Mat view = viewOf(image, box, m_cells);
  if (!view.empty()) m_views.push_back(std::move(view));
}

std::vector<Place> ColourLayout::places(const cv::Mat& image) const {
  if (m_views.empty()) return {};
  std::vector<Place> found;
  PictureHalves halves(image);
  for (int exponent = -tuning.scales; exponent <= tuning.scales; ++exponent) {
    const double scale = std::pow(tuning.scaleStep, exponent);
    const cv::Size level(cvRound(image.cols * m_cells.width / (m_size.width * scale)),
                         cvRound(image.rows * m_cells.height / (m_size.height * scale)));
    if (level.width > image.cols || level.height > image.rows) continue;
    if (level.width < m_cells.width || level.height < m_cells.height) break;
    addPlacesOf(halves.resized(level), m_views, image.size(), found);
  }
  std::ranges::stable_sort(found, std::greater(), &Place::score);
  std::vector<Place> apart;
  for (const Place& place : found) {
    if (apart.size() == tuning.maxPlaces) break;
    const bool isNew = std::ranges::none_of(
        apart, [&](const Place& other) { return isSamePlace(place.box, other.box); });
    if (isNew) apart.push_back(place);
  }
  return apart;
}

double ColourLayout::scoreOf(const cv::Mat& image, const cv::Rect2d& box) const {
  const cv::Mat seen = m_views.empty() ? cv::Mat() : viewOf(image, box, m_cells);
  double best = -1.0;
  if (seen.empty()) return best;
  for (const cv::Mat& view : m_views) best = std::max(best, view.dot(seen));
  return best;
}

/// Shifted and scaled by less than a cell to where it is most alike.
Place ColourLayout::refined(const cv::Mat& image, const Place& place) const {
  Place best = place;
  const auto attempt = [&](const cv::Rect2d& box) {
    const double score = scoreOf(image, box);
    if (score > best.score) best = {box, score};
  };
  for (const double part : {0.5, 0.25}) {
    const cv::Rect2d from = best.box;
    for (int k = 0; k < 9; ++k) {
      attempt(moved(from, {(k % 3 - 1) * part / m_cells.width, (k / 3 - 1) * part / m_cells.height},
                    1.0));
    }
    const cv::Rect2d shifted = best.box;
    for (const int grow : {-1, 1})
      attempt(moved(shifted, {}, std::pow(tuning.scaleStep, grow * part)));
  }
  return best;
}

void ColourLayout::observe(const cv::Mat& image, const std::vector<Place>& places,
                           const cv::Rect2d& box) {
  if (places.empty()) return;
  Observation seen;
  for (const Place& place : places) {
    if (overlap(place.box, box) >= tuning.onTool) seen.own = std::max(seen.own, place.score);
    if (!isSamePlace(place.box, box)) seen.other = std::max(seen.other, place.score);
  }
  m_size = box.size();
  m_observed.push_back(seen);
  if (m_observed.size() > tuning.maxObserved) m_observed.pop_front();
  if (seen.own < seen.other || m_views.size() == tuning.maxViews) return;
  const double score = scoreOf(image, box);
  if (score > tuning.sureView && score < tuning.newView)
    m_views.push_back(viewOf(image, box, m_cells));
}

std::optional<double> ColourLayout::threshold() const {
  if (m_observed.size() < tuning.minObserved) return std::nullopt;
  std::vector<double> own;
  double other = -1.0;
  for (const Observation& one : m_observed) {
    if (one.own > one.other) own.push_back(one.own);
    other = std::max(other, one.other);
  }
  if (own.size() < tuning.rightShare * static_cast<double>(m_observed.size())) return std::nullopt;
  return std::max(tuning.minScore,
                  other + std::max(tuning.margin, tuning.ownShare * (medianOf(own) - other)));
}

bool ColourLayout::denies(const cv::Mat& image, const cv::Rect2d& box) const {
  const auto least = threshold();
  return least && scoreOf(image, box) < tuning.deniedShare * *least;
}

std::optional<Place> ColourLayout::toolIn(const cv::Mat& image,
                                          const std::vector<Place>& places) const {
  const auto least = threshold();
  if (!least || places.empty() || places.front().score < *least) return std::nullopt;
  const Place best = refined(image, places[0]);
  // Half a cell off, a second one just like it would look less alike.
  if (places.size() > 1 && best.score < refined(image, places[1]).score + tuning.lead)
    return std::nullopt;
  return best;
}

}  // namespace boomwatch
