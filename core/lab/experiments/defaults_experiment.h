#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// The defaults that are not the thesis's: what each is worth on random yards.
std::optional<Chapter> runDefaultsExperiment(const ExperimentSetup& setup,
                                             const ExperimentProgress& progress);

}  // namespace boomwatch
