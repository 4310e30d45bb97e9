#include "lab/experiments/experiments.h"

#include <algorithm>

#include "lab/experiments/statistics.h"
#include "lab/experiments/yard_plan.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxYards = 8;

/// What differs from the defaults; each alone, and all of them together.
struct Change {
  const char* name;
  void (*make)(Parameters& parameters);
  bool onStereo = false;  ///< else on noisy depth
};

void thesisUpdate(Parameters& p) { p.model.update = ModelUpdate::Thesis; }
void nearestPoint(Parameters& p) { p.model.cellDepth = CellDepth::Nearest; }
void everyComponent(Parameters& p) { p.clearance.smallestThing = p.clearance.doubtfulThing = 0.0; }
void anyComponentAtOnce(Parameters& p) { p.clearance.doubtfulThing = 0.0; }
void depthAsItIs(Parameters& p) { p.filter.depthSmooth = 0; }
void veilsStay(Parameters& p) { p.stereo.maxSlope = 0.0; }
void disparityAsItIs(Parameters& p) { p.stereo.smooth = 0; }

constexpr Change changes[] = {
    {"defaults", [](Parameters&) {}},
    {"model_update=thesis", thesisUpdate},
    {"cell_depth=nearest", nearestPoint},
    {"doubtful_thing=0", anyComponentAtOnce},
    {"doubtful_thing=0, smallest_thing=0", everyComponent},
    {"depth_smooth=0", depthAsItIs},
    {"all of these: the thesis's",
     [](Parameters& p) {
       thesisUpdate(p);
       nearestPoint(p);
       everyComponent(p);
       depthAsItIs(p);
     }},
    {"defaults", [](Parameters&) {}, true},
    {"cell_depth=nearest", nearestPoint, true},
    {"stereo_steepest=0", veilsStay, true},
    {"stereo_smooth=0", disparityAsItIs, true},
    {"all of these but depth_smooth",
     [](Parameters& p) {
       thesisUpdate(p);
       nearestPoint(p);
       everyComponent(p);
       veilsStay(p);
       disparityAsItIs(p);
     },
     true},
};

YardPlan planOf(const ExperimentSetup& setup) {
  // Yards of the hour's: on those of the chain the defaults were found.
  YardPlan plan{setup.firstSeed + setup.sequences,
                std::min(setup.shifts(), maxYards),
                setup.framesOfAYard(),
                {}};
  for (const Change& change : changes) {
    Parameters parameters = setup.parameters;
    change.make(parameters);
    plan.stages.push_back(
        {change.onStereo ? ChainKind::Stereo : ChainKind::NoisyDepth, parameters});
  }
  return plan;
}

struct Outcome {
  std::size_t missed = 0, wrong = 0, frames = 0, silent = 0;
  std::vector<double> errors;

  void add(const ChainRun& run, const WarningParameters& warning) {
    missed += missedAlarms(run.frames, warning).size();
    wrong += falseAlarms(run.frames, warning).size();
    frames += run.frames.size();
    silent += static_cast<std::size_t>(
        std::ranges::count_if(run.frames, [](const ChainFrame& f) { return !f.reported; }));
    std::ranges::copy(distanceErrors(run.frames, true), std::back_inserter(errors));
  }
};

Cells cellsOf(const Change& change, const Outcome& outcome) {
  const auto silent = static_cast<double>(outcome.silent) /
                      static_cast<double>(std::max<std::size_t>(1, outcome.frames));
  Cells row{std::string(nameOf(change.onStereo ? ChainKind::Stereo : ChainKind::NoisyDepth)),
            change.name, std::to_string(outcome.missed), std::to_string(outcome.wrong),
            fixedText(silent, 1, 100.0)};
  std::ranges::move(errorCells(outcome.errors), std::back_inserter(row));
  return row;
}

}  // namespace

std::optional<Chapter> runDefaultsExperiment(const ExperimentSetup& setup,
                                             const ExperimentProgress& progress) {
  const YardPlan plan = planOf(setup);
  const auto runs = runYards(plan, progress);
  if (!runs) return std::nullopt;
  Table table{"defaults",
              "Alarms, and reported less true distance to what the camera sees, metres.",
              {"stage", "setting", "missed", "false", "frames without a distance (%)", "bias",
               "|e| 50 %", "95 %", "99 %", "> 10 cm too far (%)", "> 10 cm too near (%)"},
              {},
              2};
  for (std::size_t stage = 0; stage < plan.stages.size(); ++stage) {
    Outcome outcome;
    for (std::size_t k = stage; k < runs->size(); k += plan.stages.size()) {
      outcome.add((*runs)[k], setup.parameters.warning);
    }
    table.rows.push_back(cellsOf(changes[stage], outcome));
  }
  return Chapter{"What the defaults are worth",
                 {"Defaults that are not the thesis's, each set back to what the thesis has, on " +
                      std::to_string(plan.yards) + " yards of " + std::to_string(plan.frames) +
                      " frames from seed " + std::to_string(plan.firstSeed) +
                      "; the load and the tool's box given.",
                  alarmDefinitions(setup.parameters.warning), std::move(table)}};
}

}  // namespace boomwatch
