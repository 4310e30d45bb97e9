#include "lab/experiments/experiments.h"

#include <algorithm>

#include "lab/experiments/statistics.h"
#include "lab/experiments/yard_plan.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxYards = 4;

struct Projection {
  ModelProjection projection;
  const char* name;
};
constexpr Projection projections[] = {
    {ModelProjection::Parallel, "parallel columns (the thesis's)"},
    {ModelProjection::Perspective, "image rays"}};
constexpr ChainKind kinds[] = {ChainKind::MaskedCloud, ChainKind::MaskedDepth};

struct Errors {
  std::vector<double> seen, all;
  std::size_t frames = 0;

  void add(const ChainRun& run) {
    frames += judgedFrames(run.frames);
    std::ranges::copy(distanceErrors(run.frames, true), std::back_inserter(seen));
    std::ranges::copy(distanceErrors(run.frames, false), std::back_inserter(all));
  }
};

Cells cellsOf(const Projection& projection, ChainKind kind, const Errors& errors) {
  const auto share = errors.frames > 0 ? std::optional(static_cast<double>(errors.all.size()) /
                                                       static_cast<double>(errors.frames))
                                       : std::nullopt;
  Cells row{projection.name, std::string(nameOf(kind)), fixedText(share, 1, 100.0)};
  std::ranges::move(errorCells(errors.seen), std::back_inserter(row));
  row.back() = fixedText(shareAbove(errors.all, 0.1), 1, 100.0);  // in place of the last one
  return row;
}

}  // namespace

std::optional<Chapter> runProjectionExperiment(const ExperimentSetup& setup,
                                               const ExperimentProgress& progress) {
  YardPlan plan{setup.firstSeed, std::min(setup.sequences, maxYards), setup.framesOfAYard(), {}};
  for (const Projection& projection : projections) {
    for (const ChainKind kind : kinds) {
      plan.stages.push_back({kind, setup.parameters});
      plan.stages.back().parameters.model.projection = projection.projection;
    }
  }
  const auto runs = runYards(plan, progress);
  if (!runs) return std::nullopt;
  Table table{"projections",
              "Reported less true distance, metres, behind a perfect mask; what is seen is what "
              "this very frame sees, everything is also what it does not.",
              {"model", "points", "frames with a distance (%)", "bias to what is seen", "|e| 50 %",
               "95 %", "99 %", "> 10 cm too far (%)", "> 10 cm too far of everything (%)"},
              {},
              2};
  std::size_t stage = 0;
  for (const Projection& projection : projections) {
    for (const ChainKind kind : kinds) {
      Errors errors;
      for (std::size_t k = stage; k < runs->size(); k += plan.stages.size()) errors.add((*runs)[k]);
      table.rows.push_back(cellsOf(projection, kind, errors));
      ++stage;
    }
  }
  return Chapter{
      "Parallel columns against image rays",
      {"A column of the thesis's model holds one depth, and what stands in it is thought to go on "
       "behind: seen along the camera's rays, the model has a gap behind near objects (Fig. 17). "
       "With a cell a ray there is none, but cells widen with the distance. On " +
           std::to_string(plan.yards) + " yards, the same search in both.",
       std::move(table)}};
}

}  // namespace boomwatch
