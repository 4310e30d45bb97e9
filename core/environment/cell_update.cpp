#include "environment/cell_update.h"

#include <algorithm>

namespace boomwatch {
namespace {

/// Eq. (8).
struct Decay {
  float kept, hit;

  explicit Decay(const ModelParameters& p)
      : kept(static_cast<float>(p.pPost)),
        // What is seen is observed, however little it adds.
        hit(std::max(static_cast<float>(p.pPrior), observedFloor)) {}
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
constexpr std::size_t block = 2048;

template <class Rule>
void blend(std::span<float> probabilities, std::span<std::uint8_t> levels,
           std::span<std::uint8_t> nearness, const Rule& rule, float enter) {
  std::uint8_t enters[block];
  for (std::size_t begin = 0; begin < levels.size(); begin += block) {
    const std::size_t count = std::min(block, levels.size() - begin);
    float* const p = probabilities.data() + begin;
    std::uint8_t* const level = levels.data() + begin;
    std::uint8_t* const near = nearness.data() + begin;
    for (std::size_t k = 0; k < count; ++k) {
      const float updated = rule(p[k], near[k] != 0);
      p[k] = updated < observedFloor ? 0.0F : updated;
      enters[k] = p[k] > enter ? 0xFF : 0;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto measured = static_cast<std::uint8_t>(-near[k]);    // 256 - nearness, modulo 256
      level[k] = enters[k] & (near[k] != 0 ? measured : level[k]);  // Eq. (9)
      near[k] = 0;
    }
  }
}

/// Eq. (8) with thresholds of their own for what comes and what goes, in depth too.
struct Hysteresis {
  Decay rule;
  float enter, leave;
  float replace;    ///< what is left of a surface when what is seen before it has been seen n times
  float confirmed;  ///< of what has been seen n times

  explicit Hysteresis(const ModelParameters& p)
      : rule(p),
        enter(static_cast<float>(p.probtresh)),
        leave(static_cast<float>(p.leaveThreshold)),
        replace(static_cast<float>(highestProbability(p)) * 1.001F),
        confirmed(0.0F) {
    const int frames = framesToEnter(p).value_or(0);
    for (int n = 0; n < frames; ++n) {
      confirmed = rule(confirmed, true);
      replace *= rule.kept;
    }
    if (frames == 0) replace = -1.0F;  // nothing enters
  }

  void update(std::span<float> probabilities, std::span<std::uint8_t> levels,
              std::span<std::uint8_t> nearness) const;
};

void Hysteresis::update(std::span<float> probabilities, std::span<std::uint8_t> levels,
                        std::span<std::uint8_t> nearness) const {
  std::uint8_t hit[block], before[block], behind[block], stays[block], enters[block], taken[block];
  for (std::size_t begin = 0; begin < levels.size(); begin += block) {
    const std::size_t count = std::min(block, levels.size() - begin);
    float* const p = probabilities.data() + begin;
    std::uint8_t* const level = levels.data() + begin;
    std::uint8_t* const near = nearness.data() + begin;
    for (std::size_t k = 0; k < count; ++k) {
      const int measured = 256 - near[k];
      const int nearer = level[k] - measured;
      const bool both = near[k] != 0 && level[k] != 0;
      before[k] = both && nearer > sameSurface ? 0xFF : 0;
      behind[k] = both && -nearer > sameSurface ? 0xFF : 0;
      hit[k] = near[k] != 0 ? static_cast<std::uint8_t>(~(before[k] | behind[k])) : 0;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const float updated = rule(p[k], hit[k] != 0);
      const float limit = before[k] != 0 ? replace : behind[k] != 0 ? leave : -1.0F;
      const bool replaced = updated <= limit;
      p[k] = replaced ? confirmed : updated < observedFloor ? 0.0F : updated;
      taken[k] = replaced || (hit[k] != 0 && level[k] == 0) ? 0xFF : 0;
      enters[k] = p[k] > enter ? 0xFF : 0;
      stays[k] = p[k] > leave ? 0xFF : 0;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto measured = static_cast<std::uint8_t>(-near[k]);
      const std::uint8_t in = level[k] != 0 ? stays[k] : enters[k];
      const auto step = static_cast<std::uint8_t>((measured > level[k]) - (measured < level[k]));
      const auto moved = static_cast<std::uint8_t>(level[k] + (hit[k] & step));
      level[k] = in & (taken[k] != 0 ? measured : moved);
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
  switch (parameters.update) {
    case ModelUpdate::Thesis:
      return blend(probabilities, levels, nearness, Decay(parameters), enter);
    case ModelUpdate::Hysteresis:
      return Hysteresis(parameters).update(probabilities, levels, nearness);
    case ModelUpdate::LogOdds:
      return blend(probabilities, levels, nearness, Odds(parameters), enter);
  }
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
