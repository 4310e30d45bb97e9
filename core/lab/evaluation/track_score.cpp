#include "lab/evaluation/track_score.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace boomwatch {
namespace {

constexpr double precisionLimit = 20.0;  // pixels
constexpr int successThresholds = 21;    // 0, 0.05, ... 1

std::optional<double> ratio(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

std::optional<double> meanOf(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::optional<double> spreadOf(const std::vector<double>& values) {
  const auto mean = meanOf(values);
  if (!mean) return std::nullopt;
  std::vector<double> squares;
  squares.reserve(values.size());
  for (const double value : values) squares.push_back((value - *mean) * (value - *mean));
  return std::sqrt(*meanOf(squares));
}

double centreDistance(const cv::Rect2d& a, const cv::Rect2d& b) {
  return cv::norm((a.tl() + a.br()) * 0.5 - (b.tl() + b.br()) * 0.5);
}

std::optional<double> successArea(const std::vector<double>& overlaps) {
  std::vector<double> shares;
  for (int k = 0; k < successThresholds && !overlaps.empty(); ++k) {
    const double threshold = static_cast<double>(k) / (successThresholds - 1);
    const auto above = std::ranges::count_if(overlaps, [&](double o) { return o > threshold; });
    shares.push_back(static_cast<double>(above) / static_cast<double>(overlaps.size()));
  }
  return meanOf(shares);
}

bool isOnTarget(const TrackedFrame& frame, const std::optional<cv::Rect2d>& truth) {
  return truth && frame.track.box && overlapOf(*frame.track.box, *truth) >= refoundOverlap;
}

void countReturns(TrackScore& score, std::span<const TrackedFrame> frames,
                  std::span<const std::optional<cv::Rect2d>> truth) {
  bool followed = true;  // it was told where the target is in the frame before these
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!truth[i]) continue;
    if (i > 0 && !truth[i - 1]) {
      const std::size_t end = std::min(i + refoundWithin, truth.size());
      std::size_t k = i;
      while (k < end && !isOnTarget(frames[k], truth[k])) ++k;
      ++score.returns;
      score.followed += followed;
      score.refound += k < end;
      score.followedRefound += followed && k < end;
    }
    followed = isOnTarget(frames[i], truth[i]);
  }
}

std::optional<double> mean(std::span<const TrackScore> scores,
                           std::optional<double> TrackScore::*value) {
  std::vector<double> values;
  for (const TrackScore& score : scores) {
    if (score.*value) values.push_back(*(score.*value));
  }
  return meanOf(values);
}

}  // namespace

double overlapOf(const cv::Rect2d& a, const cv::Rect2d& b) {
  const double common = (a & b).area();
  const double both = a.area() + b.area() - common;
  return both > 0.0 ? common / both : 0.0;
}

TrackScore scoreOf(std::span<const TrackedFrame> frames,
                   std::span<const std::optional<cv::Rect2d>> truth, bool hasConfidence) {
  TrackScore score;
  std::vector<double> overlaps, confidences, rates;
  std::size_t near = 0, answered = 0;
  score.frames = truth.size();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto& box = frames[i].track.box;
    // What gave up for good and does nothing is not fast.
    if (box && frames[i].seconds > 0.0) rates.push_back(1.0 / frames[i].seconds);
    if (box && hasConfidence) confidences.push_back(frames[i].track.confidence);
    score.lost += !box;
    if (!truth[i]) {
      ++score.occluded;
      score.falseBoxes += box.has_value();
      continue;
    }
    answered += box.has_value();
    overlaps.push_back(box ? overlapOf(*box, *truth[i]) : 0.0);
    near += box && centreDistance(*box, *truth[i]) <= precisionLimit;
  }
  score.lostShare = ratio(score.lost, score.frames);
  score.accuracy = ratio(answered, overlaps.size());
  score.precision = ratio(near, overlaps.size());
  score.successArea = successArea(overlaps);
  score.confidenceMean = meanOf(confidences);
  score.confidenceSpread = spreadOf(confidences);
  score.fps = meanOf(rates);
  countReturns(score, frames, truth);
  return score;
}

TrackScore meanOf(std::span<const TrackScore> scores) {
  TrackScore result;
  for (const TrackScore& score : scores) {
    result.frames += score.frames;
    result.lost += score.lost;
    result.occluded += score.occluded;
    result.falseBoxes += score.falseBoxes;
    result.returns += score.returns;
    result.refound += score.refound;
    result.followed += score.followed;
    result.followedRefound += score.followedRefound;
  }
  for (const auto value : {&TrackScore::lostShare, &TrackScore::accuracy,
                           &TrackScore::confidenceMean, &TrackScore::confidenceSpread,
                           &TrackScore::fps, &TrackScore::successArea, &TrackScore::precision}) {
    result.*value = mean(scores, value);
  }
  return result;
}

}  // namespace boomwatch
