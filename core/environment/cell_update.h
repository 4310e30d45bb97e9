#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "parameters/parameters.h"

namespace boomwatch {

/// Probability below which a cell without measurements becomes unobserved again.
inline constexpr float observedFloor = 1e-3F;
/// Minimum probability of a cell that a point behind zMax shows to be free.
inline constexpr float seenThrough = 1e-2F;

/// Depth levels by which two measurements of one surface may differ: 3 % of the depth range.
inline constexpr int sameSurface = 8;

/// Updates a range of cells with one frame. `probabilities`: 0..1. `levels`: depth levels, 0: not
/// occupied. `nearness`: 256 - level of the measurement in the cell, 0: none; set to 0 afterwards.
///
/// - thesis: Eq. 8 and 9 (docs/method.md section 6).
/// - hysteresis: Eq. 8. A cell enters above `probtresh` and leaves at `leaveThreshold`. A
/// measurement
///   within `sameSurface` levels of the cell's surface is a hit, and moves the surface by one
///   level. This running median hardly reacts to noise. A measurement farther off is a miss. One in
///   front replaces the surface after as many frames as an object needs to enter (n of Eq. 23), one
///   behind when the surface leaves. So a falling leaf does not enter, and a surface survives
///   single misses.
/// - log-odds: Bayes' rule with the odds of a hit and of a miss, at most `logOddsHigh`. A hit
/// starts
///   from at least `logOddsLow`; misses may go below it (Hornung et al. 2013, OctoMap, eq. 2-4,
///   with their clamping and default values).
///
/// In all three, a probability below `observedFloor` becomes 0: unobserved.
void updateCells(std::span<float> probabilities, std::span<std::uint8_t> levels,
                 std::span<std::uint8_t> nearness, const ModelParameters& parameters);

/// Limit of the probability of a cell that every frame hits; for Eq. 8, p_prior / (1 - p_post).
/// Above 0, at most 1.
double maxProbability(const ModelParameters& parameters);

/// Frames in a row that must show an object before it enters the model (Eq. 22-23 for the thesis's
/// update). Absent when no object can exceed probtresh.
std::optional<int> framesToEnter(const ModelParameters& parameters);

/// Whether a cell leaves the model when every frame sees through it.
bool letsGo(const ModelParameters& parameters);

}  // namespace boomwatch
