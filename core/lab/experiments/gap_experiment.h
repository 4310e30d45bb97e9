#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// Fig. 17: what the projection leaves unobserved behind near objects.
std::optional<Chapter> runGapExperiment(const ExperimentSetup& setup,
                                        const ExperimentProgress& progress);

}  // namespace boomwatch
