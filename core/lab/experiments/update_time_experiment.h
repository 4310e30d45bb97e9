#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// Fig. 20: how long an update of the model takes, by resolution.
std::optional<Chapter> runUpdateTimeExperiment(const ExperimentSetup& setup,
                                               const ExperimentProgress& progress);

}  // namespace boomwatch
