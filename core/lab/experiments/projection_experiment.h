#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// The model of parallel columns and that of image rays on the same yards, against truth.
std::optional<Chapter> runProjectionExperiment(const ExperimentSetup& setup,
                                               const ExperimentProgress& progress);

}  // namespace boomwatch
