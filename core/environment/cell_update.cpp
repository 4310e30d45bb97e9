#include "environment/cell_update.h"

#include <algorithm>
#include <bit>

namespace boomwatch {
namespace {

/// Eq. (8).
struct Decay {
  float kept, hit;

  explicit Decay(const ModelParameters& p)
      : kept(static_cast<float>(p.pPost)),
        // A hit makes a cell observed, even if p_prior is tiny.
        hit(std::max(static_cast<float>(p.pPrior), observedFloor)) {}
  float operator()(float probability, bool measured) const {
    return kept * probability + (measured ? hit : 0.0F);
  }
};

/// Bayes' rule: prior odds times the odds of the measurement.
struct Odds {
  float hit, miss, low, high;

  explicit Odds(const ModelParameters& p)
      : hit(static_cast<float>(p.logOddsHit / (1.0 - p.logOddsHit))),
        miss(static_cast<float>(p.logOddsMiss / (1.0 - p.logOddsMiss))),
        low(static_cast<float>(p.logOddsLow)),
        high(static_cast<float>(p.logOddsHigh)) {}
  float operator()(float probability, bool measured) const {
    // By value: std::min returns a reference, which keeps its operands in memory.
    const auto smaller = [](float a, float b) { return b < a ? b : a; };
    const float least = measured ? low : 0.0F, factor = measured ? hit : miss;
    const float before = smaller(probability < least ? least : probability, high);
    const float odds = before * factor;
    return smaller(odds / (odds + (1.0F - before)), high);
  }
};

/// Cells of a block, which fits the first-level cache. The loops over a block vectorise on every
/// x86-64: they have no branch, no load inside a choice, and mostly one element size.
constexpr std::size_t block = 512;

/// Whether the cells are unobserved and this frame has no measurement in them. No rule changes such
/// cells, and most of a grid lies outside the picture.
[[gnu::always_inline]] inline bool isBlank(const float* p, const std::uint8_t* level,
                                           const std::uint8_t* near, std::size_t count) {
  std::uint8_t bytes = 0;
  for (std::size_t k = 0; k < count; ++k) bytes |= level[k] | near[k];
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < count; ++k) bits |= std::bit_cast<std::uint32_t>(p[k]);
  return bytes == 0 && bits == 0;
}

/// A rule with one threshold to enter and to leave.
template <class Rule>
struct Blend {
  Rule rule;
  float enter;

  explicit Blend(const ModelParameters& p) : rule(p), enter(static_cast<float>(p.probtresh)) {}

  [[gnu::always_inline]] inline void update(float* p, std::uint8_t* level, std::uint8_t* near,
                                            std::size_t count) const {
    const Blend limits = *this;  // a copy, because a load inside a choice is a branch
    std::uint8_t enters[block];
    for (std::size_t k = 0; k < count; ++k) {
      const float updated = limits.rule(p[k], near[k] != 0);
      p[k] = updated < observedFloor ? 0.0F : updated;
      enters[k] = p[k] > limits.enter ? 0xFF : 0;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto measured = static_cast<std::uint8_t>(-near[k]);    // 256 - nearness, modulo 256
      level[k] = enters[k] & (near[k] != 0 ? measured : level[k]);  // Eq. (9)
      near[k] = 0;
    }
  }
};

/// Eq. (8) with separate thresholds to enter and to leave, also in depth.
struct Hysteresis {
  Decay rule;
  float enter, leave;
  float replace;    ///< probability at which a surface in front replaces this one: after n misses
  float confirmed;  ///< probability after n hits

  explicit Hysteresis(const ModelParameters& p)
      : rule(p),
        enter(static_cast<float>(p.probtresh)),
        leave(static_cast<float>(p.leaveThreshold)),
        replace(static_cast<float>(maxProbability(p)) * 1.001F),
        confirmed(0.0F) {
    const int frames = framesToEnter(p).value_or(0);
    for (int n = 0; n < frames; ++n) {
      confirmed = rule(confirmed, true);
      replace *= rule.kept;
    }
    if (frames == 0) replace = -1.0F;  // no object can enter
  }

  [[gnu::always_inline]] inline void update(float* p, std::uint8_t* level, std::uint8_t* near,
                                            std::size_t count) const;
};

void Hysteresis::update(float* p, std::uint8_t* level, std::uint8_t* near,
                        std::size_t count) const {
  const Hysteresis limits = *this;  // a copy, because a load inside a choice is a branch
  std::uint8_t hit[block], before[block], behind[block], taken[block], enters[block], stays[block];
  for (std::size_t k = 0; k < count; ++k) {
    const auto measured = static_cast<std::uint8_t>(-near[k]);
    const std::uint8_t both = near[k] != 0 && level[k] != 0 ? 0xFF : 0;
    // Both differences are at least 0, so they fit a byte.
    const std::uint8_t deeper = std::max(level[k], measured);
    const auto nearer = static_cast<std::uint8_t>(deeper - measured);
    const auto farther = static_cast<std::uint8_t>(deeper - level[k]);
    before[k] = both & (nearer > sameSurface ? 0xFF : 0);
    behind[k] = both & (farther > sameSurface ? 0xFF : 0);
    hit[k] = (near[k] != 0 ? 0xFF : 0) & ~(before[k] | behind[k]);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const float updated = limits.rule(p[k], hit[k] != 0);
    const float gone = behind[k] != 0 ? limits.leave : -1.0F;
    const float limit = before[k] != 0 ? limits.replace : gone;
    const float kept = updated < observedFloor ? 0.0F : updated;
    p[k] = updated <= limit ? limits.confirmed : kept;
    taken[k] = updated <= limit ? 0xFF : 0;
    enters[k] = p[k] > limits.enter ? 0xFF : 0;
    stays[k] = p[k] > limits.leave ? 0xFF : 0;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const auto measured = static_cast<std::uint8_t>(-near[k]);
    const std::uint8_t known = level[k] != 0 ? 0xFF : 0;
    const std::uint8_t in = level[k] != 0 ? stays[k] : enters[k];
    const std::uint8_t up = measured > level[k] ? 1 : 0;
    const std::uint8_t down = measured < level[k] ? 0xFF : 0;  // -1
    const auto moved = static_cast<std::uint8_t>(level[k] + (hit[k] & (up | down)));
    const std::uint8_t take = taken[k] | (hit[k] & ~known);
    level[k] = in & (take != 0 ? measured : moved);
    near[k] = 0;
  }
}

/// The arguments of updateCells.
struct Cells {
  std::span<float> probabilities;
  std::span<std::uint8_t> levels;
  std::span<std::uint8_t> nearness;
};

template <class Rule>
[[gnu::always_inline]] inline void updateBlocks(const Cells& cells, const Rule& rule) {
  for (std::size_t begin = 0; begin < cells.levels.size(); begin += block) {
    const std::size_t count = std::min(block, cells.levels.size() - begin);
    float* const p = cells.probabilities.data() + begin;
    std::uint8_t* const level = cells.levels.data() + begin;
    std::uint8_t* const near = cells.nearness.data() + begin;
    if (!isBlank(p, level, near, count)) rule.update(p, level, near, count);
  }
}

#ifdef __x86_64__
/// Inlines everything it calls: half the time, the same result to the last bit.
template <class Rule>
[[gnu::target("avx2")]] void updateBlocksByAvx2(const Cells& cells, const Rule& rule) {
  updateBlocks(cells, rule);
}
#endif

template <class Rule>
void update(const Cells& cells, const Rule& rule) {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return updateBlocksByAvx2(cells, rule);
#endif
  updateBlocks(cells, rule);
}

/// The sum of Eq. (22), by the rule itself. Ends when the float no longer grows.
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
  const Cells cells{probabilities, levels, nearness};
  switch (parameters.update) {
    case ModelUpdate::Thesis:
      return update(cells, Blend<Decay>(parameters));
    case ModelUpdate::Hysteresis:
      return update(cells, Hysteresis(parameters));
    case ModelUpdate::LogOdds:
      return update(cells, Blend<Odds>(parameters));
  }
}

double maxProbability(const ModelParameters& parameters) {
  const double highest = parameters.update == ModelUpdate::LogOdds
                             ? parameters.logOddsHigh
                             : parameters.pPrior / (1.0 - parameters.pPost);
  return std::clamp(highest, 1e-3, 1.0);
}

std::optional<int> framesToEnter(const ModelParameters& parameters) {
  const auto limit = static_cast<float>(parameters.probtresh);
  if (parameters.update == ModelUpdate::LogOdds) return hitsToExceed(limit, Odds(parameters));
  // The limit of Eq. (8), which the sum might exceed by rounding.
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
