#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// An hour of simulated work with exact points and with noisy depth: missed and false alarms.
std::optional<Chapter> runHourExperiment(const ExperimentSetup& setup,
                                         const ExperimentProgress& progress);

}  // namespace boomwatch
