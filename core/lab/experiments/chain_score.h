#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "frame/clearance.h"
#include "pipeline/warning_level.h"
#include "simulation/yard/part.h"

namespace boomwatch {

/// Side of the smallest thing that may alarm, as the parameters have it by default. Metres.
inline constexpr double minPatch = ClearanceParameters{}.smallestThing;

/// One frame of a yard, as it is and as the chain saw it. Metres, seconds.
struct ChainFrame {
  double stamp = 0.0;
  double truth = 0.0;  ///< to everything that has its place, seen or not
  YardKind truthKind = YardKind::Nothing;
  std::optional<double> seen;  ///< to the static surfaces that the camera sees in this frame
  YardKind seenKind = YardKind::Nothing;
  std::optional<double> patch;   ///< within which a minPatch of these surfaces is seen
  std::optional<double> moving;  ///< to a person or a swaying branch
  double speed = 0.0;            ///< of the load

  std::optional<double> reported;
  Reason reason = Reason::None;  ///< why there is no distance
  WarningLevel level = WarningLevel::NoDistance;
  /// What stands where the chain has its nearest point; Nothing: nothing does.
  YardKind blamed = YardKind::Nothing;

  /// Of everything.
  double nearest() const { return moving ? std::min(truth, *moving) : truth; }
};

/// Of the beginning of a sequence nothing is judged: the model is empty.
inline constexpr double warmUp = 0.5;
/// So soon a warning must come.
inline constexpr double promptly = 0.15;

/// How many there are after the beginning.
std::size_t judgedFrames(std::span<const ChainFrame> frames);

/// Distances to the nearest thing, metres: low <= distance < high.
struct DistanceBand {
  double low = 0.0, high = std::numeric_limits<double>::infinity();
};

/// Reported less true distance to what is seen, or else to everything, where both are known and the
/// true one is in the band. The beginning is left out, and so are frames in which a person or a
/// branch is nearer: whether the model takes them up is another question.
std::vector<double> distanceErrors(std::span<const ChainFrame> frames, bool againstSeen,
                                   const DistanceBand& band = {});

/// A stretch of frames in which the warning was wrong.
struct AlarmFault {
  std::size_t first = 0, last = 0;  ///< frames
  bool withoutDistance = false;     ///< missed: in all of it the chain said that it knows nothing
  bool ofSliver = false;            ///< missed: in all of it less than a minPatch was seen there
};

/// Missed alarms: something that has its place and is seen is at most warning_distance away, and
/// for `promptly` or longer the level is neither Warning nor Collision.
std::vector<AlarmFault> missedAlarms(std::span<const ChainFrame> frames,
                                     const WarningParameters& warning);

/// False alarms: the level is Warning or Collision although everything (also what moves, and what
/// is not seen) is and was, for the release delay and `promptly` more, farther away than
/// warning_distance and than the load goes in warning_time at the fastest speed of the last half
/// second (over which its velocity is measured), and the deadband more. Two of them less than half
/// a second apart are one.
std::vector<AlarmFault> falseAlarms(std::span<const ChainFrame> frames,
                                    const WarningParameters& warning);

}  // namespace boomwatch
