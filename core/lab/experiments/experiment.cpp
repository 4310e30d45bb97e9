#include "lab/experiments/experiment.h"

#include "lab/experiments/chain_experiment.h"
#include "lab/experiments/defaults_experiment.h"
#include "lab/experiments/entry_experiment.h"
#include "lab/experiments/gap_experiment.h"
#include "lab/experiments/hour_experiment.h"
#include "lab/experiments/passing_experiment.h"
#include "lab/experiments/projection_experiment.h"
#include "lab/experiments/search_experiment.h"
#include "lab/experiments/simulator_experiment.h"
#include "lab/experiments/tracking_experiment.h"
#include "lab/experiments/update_rules_experiment.h"
#include "lab/experiments/update_time_experiment.h"

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
