#include "lab/experiments/experiments.h"

#include <cmath>

#include "environment/environment_model.h"
#include "lab/experiments/stopwatch.h"
#include "simulation/demo_source.h"

namespace boomwatch {
namespace {

/// The loop of the thesis as it describes it: every point is projected one by one, then every cell
/// is updated (Eq. 8-11). Written plainly, to compare with.
class PlainModel {
 public:
  PlainModel(const Bounds& bounds, double resolution)
      : m_bounds(bounds),
        m_resolution(resolution),
        m_columns(static_cast<int>(std::floor((bounds.xMax - bounds.xMin) / resolution))),
        m_rows(static_cast<int>(std::floor((bounds.yMax - bounds.yMin) / resolution))),
        m_cells(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows)) {}

  void update(const Points& points, const ModelParameters& parameters) {
    for (const Eigen::Vector3f& point : points) project(point.cast<double>());
    for (Cell& cell : m_cells) {
      const bool measured = cell.seen > 0;
      cell.probability = static_cast<float>(parameters.pPost * double{cell.probability} +
                                            (measured ? parameters.pPrior : 0.0));
      const bool occupied = double{cell.probability} > parameters.probtresh;
      cell.level = occupied ? (measured ? cell.seen : cell.level) : 0;
      cell.seen = 0;
    }
  }

 private:
  struct Cell {
    float probability = 0.0F;
    int level = 0;
    int seen = 0;
  };

  void project(const Eigen::Vector3d& p) {
    if (!p.allFinite() || p.z() < m_bounds.zMin || p.z() > m_bounds.zMax) return;
    const double i = std::floor((p.x() - m_bounds.xMin) / m_resolution);
    const double j = std::floor((p.y() - m_bounds.yMin) / m_resolution);
    if (i < 0 || j < 0 || i >= m_columns || j >= m_rows) return;
    const double depth = (p.z() - m_bounds.zMin) / (m_bounds.zMax - m_bounds.zMin);
    const int level = std::max(1, static_cast<int>(std::lround(255.0 * depth)));
    Cell& cell = m_cells[static_cast<std::size_t>(j) * static_cast<std::size_t>(m_columns) +
                         static_cast<std::size_t>(i)];
    if (cell.seen == 0 || level < cell.seen) cell.seen = level;
  }

  Bounds m_bounds;
  double m_resolution;
  int m_columns, m_rows;
  std::vector<Cell> m_cells;
};

std::optional<double> benched(const ExperimentSetup& setup, std::string_view name) {
  for (const BenchFigure& figure : setup.bench) {
    if (figure.name == name) return figure.value;
  }
  return std::nullopt;
}

std::string explanation(const ExperimentSetup& setup) {
  std::string text =
      "The thesis's Fig. 20 is a picture without numbers in its text; of an octree it says "
      "\"several, even dozens of seconds\". *plain* is its update loop as it describes it, written "
      "plainly; *ours* is what the program does. Both take the same 442,368 points on this "
      "machine, in two threads at most. ";
  const auto octree = benched(setup, "octomap_insertion_4cm");
  if (octree) {
    return text + "OctoMap's insertion of as many points at R 0.04 took " + fixedText(octree, 0) +
           " ms: from the benchmark's figures (`--bench`), for OctoMap is no part of the program; "
           "if they are of another machine, so is that number.";
  }
  return text +
         "OctoMap's insertion is measured by `packaging/dev bench`, for OctoMap is no part of the "
         "program: give its `build/bench.json` with `--bench` to have it here.";
}

}  // namespace

std::optional<Chapter> runUpdateTimeExperiment(const ExperimentSetup& setup,
                                               const ExperimentProgress& progress) {
  const auto source = openDemoSource("yard,frames=1,as=cloud", "demo:yard,frames=1,as=cloud");
  const FramePtr frame = source->next({}).frame;
  const Points& points = frame->cloud->points;
  Table table{"update_time",
              "Median milliseconds of one update, by resolution.",
              {"R (m)", "cells", "plain (ms)", "ours (ms)", "OctoMap (ms)"},
              {},
              1};
  Figure figure{"update_time",
                "Time of one update of the model",
                {"R (m)", true, {}, {}},
                {"time (ms)", true, {}, {}},
                {{"plain loop", {}, Series::Kind::Marked},
                 {"ours", {}, Series::Kind::Marked},
                 {"OctoMap (bench)", {}, Series::Kind::Marked}},
                {},
                {}};
  const int runs = static_cast<int>(setup.share(21));
  constexpr double resolutions[] = {0.01, 0.02, 0.03, 0.04, 0.05, 0.10};
  std::size_t done = 0;
  for (const double resolution : resolutions) {
    PlainModel plain({}, resolution);
    EnvironmentModel ours(GridGeometry({}, resolution));
    const ModelParameters& parameters = setup.parameters.model;
    const double slow = medianMilliseconds(runs, [&] { plain.update(points, parameters); });
    const double fast = medianMilliseconds(runs, [&] { ours.update(points, parameters); });
    const auto octree = resolution == 0.04 ? benched(setup, "octomap_insertion_4cm") : std::nullopt;
    table.rows.push_back({fixedText(resolution, 2), std::to_string(ours.geometry().cellCount()),
                          fixedText(slow, 2), fixedText(fast, 2), fixedText(octree, 0)});
    figure.series[0].samples.push_back({resolution, slow});
    figure.series[1].samples.push_back({resolution, fast});
    if (octree) figure.series[2].samples.push_back({resolution, octree});
    if (!progress(static_cast<double>(++done) / std::size(resolutions))) return std::nullopt;
  }
  if (figure.series[2].samples.empty()) figure.series.pop_back();
  return Chapter{"Fig. 20: time of an update",
                 {explanation(setup), std::move(table), std::move(figure)}};
}

}  // namespace boomwatch
