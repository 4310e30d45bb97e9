#include "lab/experiments/chain_score.h"

#include <algorithm>

#include "collision/approach.h"

namespace boomwatch {
namespace {

constexpr double tick = 1e-6;  // stamps are sums of fractions

bool warns(const ChainFrame& frame) {
  return frame.level == WarningLevel::Warning || frame.level == WarningLevel::Collision;
}

bool isJudged(std::span<const ChainFrame> frames, std::size_t k) {
  return frames[k].stamp - frames.front().stamp >= warmUp - tick;
}

/// Stretches of frames of which `holds` is true; those less than `apart` seconds apart are one.
template <class Holds>
std::vector<AlarmFault> stretches(std::span<const ChainFrame> frames, double apart, Holds holds) {
  std::vector<AlarmFault> found;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (!isJudged(frames, k) || !holds(k)) continue;
    const bool goesOn =
        !found.empty() && (found.back().last + 1 == k ||
                           frames[k].stamp - frames[found.back().last].stamp < apart - tick);
    if (!goesOn) found.push_back({k, k, false});
    found.back().last = k;
  }
  return found;
}

bool isOutside(std::span<const ChainFrame> frames, std::size_t k,
               const WarningParameters& warning) {
  double speed = 0.0;
  for (std::size_t j = k + 1; j-- > 0;) {
    if (frames[k].stamp - frames[j].stamp > LoadMotion::window + tick) break;
    speed = std::max(speed, frames[j].speed);
  }
  const double zone = std::max(warning.warningDistance, speed * warning.warningTime);
  return frames[k].nearest() > zone + warning.deadband;
}

}  // namespace

std::size_t judgedFrames(std::span<const ChainFrame> frames) {
  std::size_t judged = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) judged += isJudged(frames, k);
  return judged;
}

std::vector<double> distanceErrors(std::span<const ChainFrame> frames, bool againstSeen,
                                   const DistanceBand& band) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const ChainFrame& frame = frames[k];
    const auto truth = againstSeen ? frame.seen : std::optional(frame.truth);
    if (!isJudged(frames, k) || !truth || !frame.reported) continue;
    if (*truth < band.low || *truth >= band.high) continue;
    if (frame.moving && *frame.moving < *truth) continue;
    errors.push_back(*frame.reported - *truth);
  }
  return errors;
}

std::vector<AlarmFault> missedAlarms(std::span<const ChainFrame> frames,
                                     const WarningParameters& warning) {
  auto silent = stretches(frames, 0.0, [&](std::size_t k) {
    const auto& seen = frames[k].seen;
    return seen && *seen <= warning.warningDistance && !warns(frames[k]);
  });
  std::erase_if(silent, [&](const AlarmFault& fault) {
    return frames[fault.last].stamp - frames[fault.first].stamp < promptly - tick;
  });
  for (AlarmFault& fault : silent) {
    const auto stretch = frames.subspan(fault.first, fault.last - fault.first + 1);
    fault.withoutDistance = std::ranges::all_of(
        stretch, [](const ChainFrame& f) { return f.level == WarningLevel::NoDistance; });
    fault.ofSliver = std::ranges::none_of(stretch, [&](const ChainFrame& f) {
      return f.patch && *f.patch <= warning.warningDistance;
    });
  }
  return silent;
}

std::vector<AlarmFault> falseAlarms(std::span<const ChainFrame> frames,
                                    const WarningParameters& warning) {
  constexpr double apart = 0.5;
  const double memory = warning.releaseDelay + promptly;
  std::optional<double> lastInside;
  std::vector<bool> isFalse;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const ChainFrame& frame = frames[k];
    if (!isOutside(frames, k, warning)) lastInside = frame.stamp;
    const bool forgotten = !lastInside || frame.stamp - *lastInside > memory + tick;
    isFalse.push_back(warns(frame) && forgotten);
  }
  return stretches(frames, apart, [&](std::size_t k) { return isFalse[k]; });
}

}  // namespace boomwatch
