#include "experiments/hour_experiment.h"

#include <algorithm>
#include <cmath>

#include "experiments/yard_runs.h"

namespace boomwatch {
namespace {

constexpr double framesAnHour = 20.0 * 3600.0;
constexpr std::size_t framesOfAShift = 1200;  // a minute, then another yard

YardPlan planOf(const ExperimentSetup& setup) {
  const double frames = std::max(1.0, std::ceil(setup.hours * framesAnHour - 1e-6));
  const auto all = static_cast<std::size_t>(frames);
  YardPlan plan;
  plan.firstSeed = setup.firstSeed + setup.sequences;
  plan.frames = std::min(all, framesOfAShift);
  plan.yards = (all + plan.frames - 1) / plan.frames;
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
      " frames, 20 a second, which the chapter before does not use: seeds " +
      std::to_string(plan.firstSeed) + " to " + std::to_string(plan.firstSeed + plan.yards - 1) +
      ". The whole chain on exact points, and on depth with the noise of 0.2 pixels of disparity; "
      "the load and the tool's box given. *Missed* and *false* are defined there.");
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
