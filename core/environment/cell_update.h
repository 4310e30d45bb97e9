#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "parameters/parameters.h"

namespace boomwatch {

/// Where an observed cell that nothing is measured in any more counts as unobserved again.
inline constexpr float observedFloor = 1e-3F;
/// What a point behind zMax makes of its cell: seen through in this frame.
inline constexpr float seenThrough = 1e-2F;

/// Depth levels by which two measurements of one surface may differ: 3 % of the depth range.
inline constexpr int sameSurface = 8;

/// One frame for a stretch of cells: their probabilities, their depth levels (0: not occupied) and
/// 256 - level of what was measured in them, 0 for nothing, which is set back to 0. By `update`:
///
/// - thesis: Eq. 8 and 9 of docs/method.md section 6.
/// - hysteresis: Eq. 8; a cell enters above `probtresh` and leaves at `leaveThreshold`. What is
///   measured more than `sameSurface` levels before or behind a cell's surface is a miss of it, not
///   a hit. Before it, it takes the cell when it has been seen as often as a thing that enters (n
///   of Eq. 23); behind it, when the surface would leave. So a leaf that falls past does not count,
///   by whatever background, and a surface that is missed now and then stays. What differs by
///   less moves the surface by one level a frame: a running median, which noise and a leaf right
///   before a wall hardly move.
/// - log-odds: Bayes' rule with the odds of a hit and of a miss, held below `logOddsHigh`; a hit
///   counts from `logOddsLow` at least (Hornung et al. 2013, OctoMap, eq. 2-4, whose clamping and
///   default values these are). A cell that is missed goes on below it, until it is forgotten.
///
/// In all three a probability below `observedFloor` becomes 0: unobserved.
void updateCells(std::span<float> probabilities, std::span<std::uint8_t> levels,
                 std::span<std::uint8_t> nearness, const ModelParameters& parameters);

/// What the probability of a cell that is always hit tends to: of Eq. 8, p_prior / (1 - p_post).
/// At most 1, and more than 0.
double maxProbability(const ModelParameters& parameters);

/// Frames in a row that a thing must be seen to enter the model (Eq. 22-23 for the thesis's
/// update); absent when probtresh lets nothing through.
std::optional<int> framesToEnter(const ModelParameters& parameters);

/// Whether a cell that is looked through in every frame still leaves the model.
bool letsGo(const ModelParameters& parameters);

}  // namespace boomwatch
