#pragma once

#include <vector>

#include "lab/experiments/chain_tables.h"
#include "lab/experiments/experiment.h"

namespace boomwatch {

/// Random yards that go through stages of the chain.
struct YardPlan {
  struct Stage {
    ChainKind kind = ChainKind::TruthCloud;
    Parameters parameters;
  };
  std::uint64_t firstSeed = 1;
  std::size_t yards = 1;
  std::size_t frames = 0;  ///< of each
  std::vector<Stage> stages;
};

/// All of it, two yards at a time: they share nothing, so the outcome is that of one after another.
/// In the order of seeds, and of stages in each. Absent when the progress, which is called by this
/// thread, said no. Throws what sources throw.
std::optional<std::vector<ChainRun>> runYards(const YardPlan& plan,
                                              const ExperimentProgress& progress);

}  // namespace boomwatch
