#include "lab/experiments/experiments.h"

#include <algorithm>

#include "lab/experiments/yard_plan.h"

namespace boomwatch {
namespace {

YardPlan planOf(const ExperimentSetup& setup) {
  YardPlan plan;
  plan.firstSeed = setup.firstSeed + setup.sequences;
  plan.frames = std::min(setup.framesOfWork(), ExperimentSetup::framesOfAShift);
  plan.yards = setup.shifts();
  for (const ChainKind kind : {ChainKind::TruthCloud, ChainKind::NoisyDepth}) {
    plan.stages.push_back({kind, setup.parameters});
  }
  return plan;
}

}  // namespace

std::optional<Chapter> runHourExperiment(const ExperimentSetup& setup,
                                         const ExperimentProgress& progress) {
  const YardPlan plan = planOf(setup);
  const auto runs = runYards(plan, progress);
  if (!runs) return std::nullopt;
  const WarningParameters& warning = setup.parameters.warning;
  Chapter chapter{"Missed and false alarms in an hour of work", {}};
  chapter.items.emplace_back(
      std::to_string(plan.yards) + " yards of " + std::to_string(plan.frames) +
      " frames, 20 a second, none of which the other chapters use: seeds " +
      std::to_string(plan.firstSeed) + " to " + std::to_string(plan.firstSeed + plan.yards - 1) +
      ". The whole chain on exact points, and on depth with the noise of 0.2 pixels of disparity; "
      "the load and the tool's box given.");
  chapter.items.emplace_back(alarmDefinitions(warning));
  Table alarms = chainAlarms(*runs, warning), faults = chainFaults(*runs, warning);
  Table errors = chainErrors(*runs, true), reasons = chainReasons(*runs);
  Table frames = chainFrames(*runs);
  for (Table* table : {&alarms, &faults, &errors, &reasons, &frames}) {
    table->file = "hour_" + table->file;
    chapter.items.emplace_back(std::move(*table));
  }
  return chapter;
}

}  // namespace boomwatch
