#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// Eq. 22-23: in how many frames in a row a thing must be seen to enter the model, by probtresh.
std::optional<Chapter> runEntryExperiment(const ExperimentSetup& setup,
                                          const ExperimentProgress& progress);

}  // namespace boomwatch
