#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// Fig. 21 and 22: distances along the whole path of the simulator's load.
std::optional<Chapter> runSimulatorExperiment(const ExperimentSetup& setup,
                                              const ExperimentProgress& progress);

}  // namespace boomwatch
