#pragma once

#include <memory>
#include <string>

#include "lab/evaluation/tracking_sequence.h"
#include "lab/experiments/experiment.h"

namespace boomwatch {

/// A random yard as a tracking sequence: the left pictures, and the true box of the tool where at
/// least half of it is seen. Renders every frame once for the truth, and once more when it is read.
/// Absent when the progress (0..1 of the first time) said no, or the tool is never seen.
std::optional<TrackingSequence> yardSequence(std::uint64_t seed, std::size_t frames,
                                             const ExperimentProgress& progress);

}  // namespace boomwatch
