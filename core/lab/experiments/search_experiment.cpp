#include "lab/experiments/experiments.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "collision/exact_clearance.h"
#include "collision/ray_clearance.h"
#include "lab/experiments/stopwatch.h"
#include "simulation/demo_source.h"

namespace boomwatch {
namespace {

constexpr const char* scene = "yard,frames=1,as=cloud,person=off,clutter=off";
constexpr double unlimited = HUGE_VAL;
constexpr double unsafe = 0.1;  // metres

/// A row of Table 6, with the thesis's own milliseconds.
struct Row {
  double resolution;
  int interval, radius;
  double thesis;
};
constexpr std::array rows{Row{0.01, 8, 70, 20.46}, Row{0.02, 8, 70, 9.97},   Row{0.03, 8, 70, 7.12},
                          Row{0.05, 8, 70, 4.33},  Row{0.02, 8, 100, 12.70}, Row{0.02, 8, 70, 9.97},
                          Row{0.02, 5, 70, 8.32}};

EnvironmentModel modelOf(const Points& points, double resolution, const ModelParameters& rule) {
  EnvironmentModel model(GridGeometry(Bounds{}, resolution));
  for (int frame = 0; frame < 6; ++frame) model.update(points, rule);
  return model;
}

/// The thesis's load, anyhow turned about the vertical and a little tilted, where a crane has it.
OrientedBox anyLoad(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  constexpr double pi = std::numbers::pi;
  const double z = between(2.5, 8.5);
  return {{between(-0.5, 0.5) * z, between(-0.3, 0.3) * z, z},
          {2.0, 0.3, 0.3},
          rotationFromYawPitchRoll(between(-pi, pi), between(-0.3, 0.3), between(-0.3, 0.3))};
}

/// Every occupied cell, looked at one by one.
std::optional<double> bruteForce(const EnvironmentModel& model, const OrientedBox& load) {
  const GridGeometry& geometry = model.geometry();
  double nearest = unlimited;
  for (int row = 0; row < geometry.rows(); ++row) {
    for (int column = 0; column < geometry.columns(); ++column) {
      const int level = model.levels()[geometry.index(column, row)];
      if (level == 0) continue;
      const Eigen::Vector3d p = geometry.surfacePoint(column, row, level);
      nearest = std::min(nearest, (load.nearestTo(p) - p).squaredNorm());
    }
  }
  return std::isfinite(nearest) ? std::optional(std::sqrt(nearest)) : std::nullopt;
}

struct Outcome {
  std::vector<double> raysTime, exactTime;  ///< ms
  std::vector<double> raysExcess;           ///< metres, where something is within the rays' length
  std::size_t raysFoundNothing = 0;
  double exactError = 0.0;  ///< metres, the largest difference to brute force
  std::size_t exactOver = 0, checked = 0;
};

Outcome searched(const EnvironmentModel& model, const Row& row, std::size_t poses,
                 std::size_t checks) {
  ExactClearance exact;
  exact.rebuild(model);
  std::mt19937 random(6);
  Outcome outcome;
  for (std::size_t pose = 0; pose < poses; ++pose) {
    const OrientedBox load = anyLoad(random);
    Clearance byRays, byExact;
    outcome.raysTime.push_back(
        millisecondsOf([&] { byRays = rayClearance(model, load, row.interval, row.radius); }));
    outcome.exactTime.push_back(millisecondsOf([&] { byExact = exact.query(load, unlimited); }));
    if (!byExact.nearest) continue;
    const double least = byExact.nearest->distance;
    if (least <= row.radius * row.resolution) {
      outcome.raysFoundNothing += !byRays.nearest;
      outcome.raysExcess.push_back(byRays.nearest ? byRays.nearest->distance - least : unlimited);
    }
    if (outcome.checked >= checks) continue;
    const double error = least - *bruteForce(model, load);
    ++outcome.checked;
    outcome.exactError = std::max(outcome.exactError, std::abs(error));
    outcome.exactOver += error > unsafe;
  }
  return outcome;
}

Cells timeCells(const Row& row, const Outcome& outcome) {
  const auto median = [](const std::vector<double>& times) { return quantileOf(times, 0.5); };
  return {fixedText(row.resolution, 2),
          "20",
          "11.5",
          std::to_string(row.interval),
          std::to_string(row.radius),
          fixedText(row.thesis, 2),
          fixedText(median(outcome.raysTime), 3),
          fixedText(median(outcome.exactTime), 3)};
}

Cells excessCells(const Row& row, const Outcome& outcome) {
  std::vector<double> finite;
  std::ranges::copy_if(outcome.raysExcess, std::back_inserter(finite),
                       [](double e) { return std::isfinite(e); });
  return {fixedText(row.resolution, 2),
          std::to_string(row.interval),
          std::to_string(row.radius),
          std::to_string(outcome.raysExcess.size()),
          fixedText(shareAbove(outcome.raysExcess, unsafe), 1, 100.0),
          fixedText(shareAbove(outcome.raysExcess, 0.5), 1, 100.0),
          std::to_string(outcome.raysFoundNothing),
          fixedText(quantileOf(finite, 1.0), 2),
          std::to_string(outcome.exactOver) + " of " + std::to_string(outcome.checked),
          fixedText(outcome.exactError, 6)};
}

std::string peers(const ExperimentSetup& setup) {
  std::string text;
  for (const BenchFigure& figure : setup.bench) {
    if (!figure.name.starts_with("clearance_query")) continue;
    text += (text.empty() ? "" : ", ") + figure.name + " " + fixedText(figure.value, 1) + " " +
            figure.unit;
  }
  if (text.empty()) {
    return "FCL beside them is measured by `packaging/dev bench`, for it is no part of the "
           "program: give its `build/bench.json` with `--bench` to have it here.";
  }
  return "From the benchmark's figures (`--bench`; FCL is no part of the program): " + text + ".";
}

}  // namespace

std::optional<Chapter> runSearchExperiment(const ExperimentSetup& setup,
                                           const ExperimentProgress& progress) {
  const auto source = openDemoSource(scene, std::string("demo:") + scene);
  const FramePtr frame = source->next({}).frame;
  Table times{
      "search_times",
      "Table 6: median milliseconds of one search (the exact one does not depend on "
      "interval and radius).",
      {"R (m)", "X (m)", "Y (m)", "interval", "radius", "thesis (ms)", "rays (ms)", "exact (ms)"},
      {},
      0};
  Table excess{"search_over_estimates",
               "How much more the rays say than there is, over the poses with something within "
               "their length; and exact against looking at every cell.",
               {"R (m)", "interval", "radius", "poses", "rays > 10 cm over (%)",
                "rays > 50 cm over (%)", "rays found nothing", "worst of rays (m)",
                "exact > 10 cm over", "largest error of exact (m)"},
               {},
               0};
  const std::size_t poses = setup.share(2000);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const EnvironmentModel model =
        modelOf(frame->cloud->points, rows[k].resolution, setup.parameters.model);
    const Outcome outcome = searched(model, rows[k], poses, setup.share(100));
    times.rows.push_back(timeCells(rows[k], outcome));
    excess.rows.push_back(excessCells(rows[k], outcome));
    if (!progress(static_cast<double>(k + 1) / rows.size())) return std::nullopt;
  }
  return Chapter{
      "Table 6: the search for the nearest thing",
      {"On a yard of 442,368 points, a load of 2 x 0.3 x 0.3 m in " + std::to_string(poses) +
           " random poses (always the same). The thesis prints the second row twice, "
           "and less time for interval 5 than for 8, which cannot be. Its times are of "
           "an i5-3470 at 3.2 GHz. " +
           peers(setup),
       std::move(times), std::move(excess)}};
}

}  // namespace boomwatch
