#pragma once

#include "lab/experiments/experiment.h"

namespace boomwatch {

// Each is one chapter of the report, or absent when the progress said no.

/// Table 5: trackers on the recordings, and on the yard with the true box of
/// the tool.
std::optional<Chapter> runTrackingExperiment(const ExperimentSetup& setup,
                                             const ExperimentProgress& progress);

/// Eq. 22-23: in how many frames in a row a thing must be seen to enter the
/// model, by probtresh.
std::optional<Chapter> runEntryExperiment(const ExperimentSetup& setup,
                                          const ExperimentProgress& progress);

/// Fig. 17: what the projection leaves unobserved behind near objects.
std::optional<Chapter> runGapExperiment(const ExperimentSetup& setup,
                                        const ExperimentProgress& progress);

/// Fig. 18 and 19: somebody walks past; a sheet is swung and then held still.
std::optional<Chapter> runPassingExperiment(const ExperimentSetup& setup,
                                            const ExperimentProgress& progress);

/// Fig. 20: how long an update of the model takes, by resolution.
std::optional<Chapter> runUpdateTimeExperiment(const ExperimentSetup& setup,
                                               const ExperimentProgress& progress);

/// Table 6: how long the search takes, and how often rays say more than is
/// true.
std::optional<Chapter> runSearchExperiment(const ExperimentSetup& setup,
                                           const ExperimentProgress& progress);

/// Fig. 21 and 22: distances along the whole path of the simulator's load.
std::optional<Chapter> runSimulatorExperiment(const ExperimentSetup& setup,
                                              const ExperimentProgress& progress);

/// The three updates of the model on the yard: flicker, latency, false cells.
std::optional<Chapter> runUpdateRulesExperiment(const ExperimentSetup& setup,
                                                const ExperimentProgress& progress);

/// The model of parallel columns and that of image rays on the same yards,
/// against truth.
std::optional<Chapter> runProjectionExperiment(const ExperimentSetup& setup,
                                               const ExperimentProgress& progress);

/// The defaults that are not the thesis's: what each is worth on random yards.
std::optional<Chapter> runDefaultsExperiment(const ExperimentSetup& setup,
                                             const ExperimentProgress& progress);

/// The whole chain on random yards against truth: error, missed and false
/// alarms.
std::optional<Chapter> runChainExperiment(const ExperimentSetup& setup,
                                          const ExperimentProgress& progress);

/// An hour of simulated work with exact points and with noisy depth: missed and
/// false alarms.
std::optional<Chapter> runHourExperiment(const ExperimentSetup& setup,
                                         const ExperimentProgress& progress);

}  // namespace boomwatch
