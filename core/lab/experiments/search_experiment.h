#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// Table 6: how long the search takes, and how often rays say more than is true.
std::optional<Chapter> runSearchExperiment(const ExperimentSetup& setup,
                                           const ExperimentProgress& progress);

}  // namespace boomwatch
