#include "lab/experiments/experiment.h"

#include "lab/experiments/experiments.h"

namespace boomwatch {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      {"trackers", runTrackingExperiment},
      {"frames to enter", runEntryExperiment},
      {"gap", runGapExperiment},
      {"passing by", runPassingExperiment},
      {"update time", runUpdateTimeExperiment},
      {"search", runSearchExperiment},
      {"simulator", runSimulatorExperiment},
      {"update rules", runUpdateRulesExperiment},
      {"projections", runProjectionExperiment},
      {"defaults", runDefaultsExperiment},
      {"the whole chain", runChainExperiment},
      {"an hour of work", runHourExperiment},
  };
  return all;
}

}  // namespace boomwatch
