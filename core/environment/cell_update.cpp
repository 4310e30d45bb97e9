#include "environment/cell_update.h"

#include <algorithm>

namespace boomwatch {
namespace {

/// Eq. (8).
struct Decay {
  float kept, hit;

  explicit Decay(const ModelParameters& p)
      : kept(static_cast<float>(p.pPost)), hit(static_cast<float>(p.pPrior)) {}
  float operator()(float probability, bool measured) const {
    return kept * probability + (measured ? hit : 0.0F);
  }
};

/// Bayes' rule: the odds of what was known, times those of what was seen.
struct Odds {
  float hit, miss, low, high;

  explicit Odds(const ModelParameters& p)
      : hit(static_cast<float>(p.logOddsHit / (1.0 - p.logOddsHit))),
        miss(static_cast<float>(p.logOddsMiss / (1.0 - p.logOddsMiss))),
        low(static_cast<float>(p.logOddsLow)),
        high(static_cast<float>(p.logOddsHigh)) {}
  float operator()(float probability, bool measured) const {
    const float before = std::min(std::max(probability, measured ? low : 0.0F), high);
    const float odds = before * (measured ? hit : miss);
    return std::min(odds / (odds + (1.0F - before)), high);
  }
};

/// Blocks that stay in the first-level cache: the two loops of a block each work on one element
/// size, and so vectorise on every x86-64.
template <bool twoThresholds, class Rule>
void blend(std::span<float> probabilities, std::span<std::uint8_t> levels,
           std::span<std::uint8_t> nearness, const Rule& rule, float enter, float leave) {
  constexpr std::size_t block = 2048;
  std::uint8_t enters[block];
  std::uint8_t stays[block];
  for (std::size_t begin = 0; begin < levels.size(); begin += block) {
    const std::size_t count = std::min(block, levels.size() - begin);
    float* const p = probabilities.data() + begin;
    std::uint8_t* const level = levels.data() + begin;
    std::uint8_t* const near = nearness.data() + begin;
    for (std::size_t k = 0; k < count; ++k) {
      const float updated = rule(p[k], near[k] != 0);
      p[k] = updated < observedFloor ? 0.0F : updated;
      enters[k] = p[k] > enter ? 0xFF : 0;
      if constexpr (twoThresholds) stays[k] = p[k] > leave ? 0xFF : 0;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto measured = static_cast<std::uint8_t>(-near[k]);  // 256 - nearness, modulo 256
      std::uint8_t in = enters[k];
      if constexpr (twoThresholds) in = level[k] != 0 ? stays[k] : enters[k];
      level[k] = in & (near[k] != 0 ? measured : level[k]);  // Eq. (9)
      near[k] = 0;
    }
  }
}

/// The sum of Eq. (22), as the rule builds it; it stops growing where float can tell no more apart.
template <class Rule>
std::optional<int> hitsToExceed(float limit, const Rule& rule) {
  float probability = 0.0F;
  for (int frames = 1;; ++frames) {
    const float next = rule(probability, true);
    if (next > limit) return frames;
    if (next <= probability) return std::nullopt;
    probability = next;
  }
}

double leavingThreshold(const ModelParameters& parameters) {
  return parameters.update == ModelUpdate::Hysteresis ? parameters.leaveThreshold
                                                      : parameters.probtresh;
}

}  // namespace

void updateCells(std::span<float> probabilities, std::span<std::uint8_t> levels,
                 std::span<std::uint8_t> nearness, const ModelParameters& parameters) {
  const auto enter = static_cast<float>(parameters.probtresh);
  if (parameters.update == ModelUpdate::LogOdds) {
    return blend<false>(probabilities, levels, nearness, Odds(parameters), enter, enter);
  }
  Decay rule(parameters);
  rule.hit = std::max(rule.hit, observedFloor);  // what is seen is observed, however little it adds
  if (parameters.update == ModelUpdate::Thesis) {
    return blend<false>(probabilities, levels, nearness, rule, enter, enter);
  }
  blend<true>(probabilities, levels, nearness, rule, enter,
              static_cast<float>(parameters.leaveThreshold));
}

double highestProbability(const ModelParameters& parameters) {
  const double highest = parameters.update == ModelUpdate::LogOdds
                             ? parameters.logOddsHigh
                             : parameters.pPrior / (1.0 - parameters.pPost);
  return std::clamp(highest, 1e-3, 1.0);
}

std::optional<int> framesToEnter(const ModelParameters& parameters) {
  const auto limit = static_cast<float>(parameters.probtresh);
  if (parameters.update == ModelUpdate::LogOdds) return hitsToExceed(limit, Odds(parameters));
  // The fixed point of Eq. (8), which the sum may come to by rounding alone.
  if (parameters.probtresh >= parameters.pPrior / (1.0 - parameters.pPost)) return std::nullopt;
  return hitsToExceed(limit, Decay(parameters));
}

bool letsGo(const ModelParameters& parameters) {
  const float left = parameters.update == ModelUpdate::LogOdds
                         ? Odds(parameters)(seenThrough, false)
                         : Decay(parameters)(seenThrough, false);
  return left < observedFloor || left <= static_cast<float>(leavingThreshold(parameters));
}

}  // namespace boomwatch
