#include "lab/experiments/experiments.h"

#include "lab/experiments/yard_plan.h"

namespace boomwatch {
namespace {

std::string definitions(const ExperimentSetup& setup) {
  return "Yards of seed " + std::to_string(setup.firstSeed) + " to " +
         std::to_string(setup.firstSeed + setup.sequences - 1) + ", " +
         std::to_string(setup.framesOfAYard()) +
         " frames each, 20 a second, with a person, swaying branches, birds and falling leaves "
         "(`demo:yard,path=random,seed=N,frames=M`). The same frames go through six stages: exact "
         "points, and depth with the noise of 0.2 pixels of disparity, both with crane, tool and "
         "load taken out pixel by pixel as the simulation knows them; the whole chain on the same "
         "points, on the same depth and on the stereo pair, with the load and the tool's true box "
         "given; and the stereo pair with the "
         "tool tracked from its first box and the load detected.";
}

}  // namespace

std::optional<Chapter> runChainExperiment(const ExperimentSetup& setup,
                                          const ExperimentProgress& progress) {
  YardPlan plan{setup.firstSeed, setup.sequences, setup.framesOfAYard(), {}};
  for (const ChainKind kind : chainKinds) plan.stages.push_back({kind, setup.parameters});
  const auto done = runYards(plan, progress);
  if (!done) return std::nullopt;
  const std::vector<ChainRun>& runs = *done;
  const WarningParameters& warning = setup.parameters.warning;
  Chapter chapter{"The whole chain on random yards", {}};
  chapter.items.emplace_back(definitions(setup));
  chapter.items.emplace_back(alarmDefinitions(warning));
  chapter.items.emplace_back(chainAlarms(runs, warning));
  chapter.items.emplace_back(chainFaults(runs, warning));
  chapter.items.emplace_back(chainErrors(runs, true));
  chapter.items.emplace_back(chainErrors(runs, false));
  chapter.items.emplace_back(chainReasons(runs));
  for (std::size_t k = 0; k < chainKinds.size(); ++k) {
    Figure figure = chainFigure(runs[k], warning);
    figure.file = "chain_distance_" + std::to_string(k + 1);
    chapter.items.emplace_back(std::move(figure));
  }
  chapter.items.emplace_back(chainFrames(runs));
  return chapter;
}

}  // namespace boomwatch
