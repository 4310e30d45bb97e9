#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// Fig. 18 and 19: somebody walks past; a sheet is swung and then held still.
std::optional<Chapter> runPassingExperiment(const ExperimentSetup& setup,
                                            const ExperimentProgress& progress);

}  // namespace boomwatch
