#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// The three updates of the model on the yard: flicker, latency, false cells.
std::optional<Chapter> runUpdateRulesExperiment(const ExperimentSetup& setup,
                                                const ExperimentProgress& progress);

}  // namespace boomwatch
