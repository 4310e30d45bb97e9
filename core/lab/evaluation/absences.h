#pragma once

#include <cstddef>
#include <optional>

#include "lab/evaluation/tracking_sequence.h"

namespace boomwatch {

/// How long the target is away each time, frames.
inline constexpr std::size_t absenceLength = 40;

/// Takes the target out of the pictures `count` times for absenceLength frames, evenly spread over
/// the first `frames` frames (all: absent): what is beside it is painted over it, and truth says
/// that it cannot be seen; "+absences" is put behind the name. It comes back where it then is in
/// the recording. An absence is left out where the recording itself does not show the target just
/// before it and refoundWithin frames after it. Published recordings seldom let their target go and
/// come back; a tracker of a tool that hangs from a crane has to expect it every minute.
void addAbsences(TrackingSequence& sequence, std::size_t count,
                 std::optional<std::size_t> frames = std::nullopt);

}  // namespace boomwatch
