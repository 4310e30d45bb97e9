#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// Table 5: trackers on the recordings, and on the yard with the true box of the tool.
std::optional<Chapter> runTrackingExperiment(const ExperimentSetup& setup,
                                             const ExperimentProgress& progress);

}  // namespace boomwatch
