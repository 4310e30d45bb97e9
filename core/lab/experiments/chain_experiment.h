#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

/// The whole chain on random yards against truth: error, missed and false alarms.
std::optional<Chapter> runChainExperiment(const ExperimentSetup& setup,
                                          const ExperimentProgress& progress);

}  // namespace boomwatch
