#include "lab/experiments/experiments.h"

#include <array>

#include "lab/experiments/rule_watch.h"
#include "lab/experiments/statistics.h"
#include "lab/experiments/true_tool.h"
#include "lab/experiments/update_rule.h"
#include "pipeline/pipeline.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxYards = 3;

using AllFigures = std::array<RuleWatch::Figures, updateRules.size()>;

std::vector<bool> cellsOf(const GridGeometry& geometry, const Points& points) {
  std::vector<bool> cells(geometry.cellCount());
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector2d q = geometry.onPlane(p.cast<double>());
    const int column = geometry.columnOf(q.x()), row = geometry.rowOf(q.y());
    if (geometry.contains(column, row)) cells[geometry.index(column, row)] = true;
  }
  return cells;
}

/// One yard, filtered once, learnt by all three; false when the progress said no.
bool runYard(std::uint64_t seed, const ExperimentSetup& setup, const ExperimentProgress& progress,
             AllFigures& figures) {
  const std::string options = "as=depth,path=random,seed=" + std::to_string(seed) +
                              ",frames=" + std::to_string(setup.framesOfAYard());
  const YardSource source(options);
  Parameters parameters = setup.parameters;
  parameters.load.source = LoadSource::Scene;
  const GridGeometry geometry(parameters.bounds, parameters.model.resolution,
                              parameters.model.projection);
  std::vector<EnvironmentModel> models(updateRules.size(), EnvironmentModel(geometry));
  std::vector<RuleWatch> watches(updateRules.size(), RuleWatch(geometry));
  TrueTool tool;
  Pipeline pipeline(tool.maker());
  pipeline.order(TrueTool::order());
  for (std::size_t frameIndex = 0; frameIndex < setup.framesOfAYard(); ++frameIndex) {
    const YardFrame shown = source.at(frameIndex);
    tool.set(toolBoxIn(shown, 0.25));
    const Result result = pipeline.process(shown.frame, parameters);
    const CellTruth truth(geometry, *shown.truth);
    Points evidence = result.scene.statics, masked = result.scene.removed;
    evidence.insert(evidence.end(), result.scene.beyond.begin(), result.scene.beyond.end());
    const std::vector<bool> hidden = cellsOf(geometry, masked);
    masked.insert(masked.end(), result.scene.noise.begin(), result.scene.noise.end());
    for (std::size_t k = 0; k < updateRules.size(); ++k) {
      ModelParameters rule = parameters.model;
      rule.update = updateRules[k].update;
      models[k].update(evidence, rule, masked);
      watches[k].look(models[k], truth, hidden);
    }
    const auto done = static_cast<double>(frameIndex + 1);
    if (!progress(done / static_cast<double>(setup.framesOfAYard()))) return false;
  }
  for (std::size_t k = 0; k < updateRules.size(); ++k) watches[k].addTo(figures[k]);
  return true;
}

Cells cellsOf(const char* name, const RuleWatch::Figures& f) {
  const auto share =
      f.visits > 0
          ? std::optional(static_cast<double>(f.latencyIn.size()) / static_cast<double>(f.visits))
          : std::nullopt;
  return {name,
          std::to_string(f.flicker.size()),
          fixedText(meanOf(f.flicker), 2),
          fixedText(shareAbove(f.flicker, 0.0), 1, 100.0),
          fixedText(share, 0, 100.0),
          fixedText(quantileOf(f.latencyIn, 0.5), 0),
          fixedText(quantileOf(f.latencyIn, 0.95), 0),
          fixedText(quantileOf(f.latencyOut, 0.5), 0),
          fixedText(quantileOf(f.latencyOut, 0.95), 0),
          fixedText(meanOf(f.falseCells), 0),
          fixedText(meanOf(f.movingCells), 0)};
}

}  // namespace

std::optional<Chapter> runUpdateRulesExperiment(const ExperimentSetup& setup,
                                                const ExperimentProgress& progress) {
  const std::size_t yards = std::min(setup.sequences, maxYards);
  AllFigures figures;
  for (std::size_t k = 0; k < yards; ++k) {
    const auto part = [&](double share) {
      return progress((static_cast<double>(k) + share) / static_cast<double>(yards));
    };
    if (!runYard(setup.firstSeed + k, setup, part, figures)) return std::nullopt;
  }
  Table table{"update_rules",
              "The three updates on the same frames.",
              {"update", "cells always seen", "flicker (changes in 100 frames)", "that flicker (%)",
               "visits shown (% of long ones)", "frames to appear, 50 %", "95 %",
               "frames to leave, 50 %", "95 %", "false cells", "cells with what moves"},
              {},
              1};
  for (std::size_t k = 0; k < updateRules.size(); ++k) {
    table.rows.push_back(cellsOf(updateRules[k].name, figures[k]));
  }
  return Chapter{
      "The three updates of the model",
      {"On " + std::to_string(yards) +
           " yards with noisy depth, a person who walks, swaying branches, birds and leaves. "
           "*Flicker*: of cells in which the exact depth shows something that has its place in "
           "every frame, and nothing else. A *visit*: something that moves is in a cell, nearer "
           "or farther than what has its place there; long ones last for four frames or more. "
           "*Shown*: the cell has its depth. By the thesis's update cells that were occupied "
           "before "
           "take it over at once (Eq. 9), so that shorter visits are shown too, and the share can "
           "be above 100. *False*: occupied cells a frame in whose neighbourhood something is "
           "seen, "
           "but nothing at that depth: noise, and what is no longer there.",
       std::move(table)}};
}

}  // namespace boomwatch
