#include "lab/experiments/experiments.h"

#include <array>

#include "collision/ray_clearance.h"
#include "lab/experiments/statistics.h"
#include "pipeline/pipeline.h"
#include "simulation/demo_source.h"
#include "simulation/scene.h"

namespace boomwatch {
namespace {

struct Place {
  double time = 0.0;
  double truth = 0.0;          ///< to everything, seen or not
  std::optional<double> seen;  ///< to the surfaces that the camera sees
  std::optional<double> exact, rays;
};

std::optional<double> distanceOf(const Clearance& clearance) {
  return clearance.nearest ? std::optional(clearance.nearest->distance) : std::nullopt;
}

/// A frame of the path as if those between were never there: a jump in time would begin the model
/// anew.
FramePtr nextOnPath(const Frame& frame, std::size_t number) {
  auto next = std::make_shared<Frame>(frame);
  next->sequence = number;
  next->stamp = static_cast<double>(number) * 0.05;
  return next;
}

/// The whole path of a demo's load, every `stride`th frame; empty when the progress said no.
std::vector<Place> pathOf(const std::string& demo, std::size_t stride, const Parameters& given,
                          const std::function<bool(double)>& progress) {
  const auto source = openDemoSource(demo, "demo:" + demo);
  Parameters parameters = given;
  parameters.clearance.method = ClearanceMethod::Exact;
  parameters.load.source = LoadSource::Scene;
  Pipeline pipeline;
  // The load is in the picture only: the surroundings are learnt before it sets out.
  std::size_t number = 0;
  for (; number < 8; ++number) {
    pipeline.process(nextOnPath(*source->next({}).frame, number), parameters);
  }
  std::vector<Place> path;
  const std::size_t all = source->info().frameCount.value_or(0);
  for (std::size_t index = 0; index < all; index += stride) {
    source->seek(index);
    const FramePtr frame = source->next({}).frame;
    const Result result = pipeline.process(nextOnPath(*frame, number++), parameters);
    const Clearance rays = rayClearance(pipeline.model(), *frame->load,
                                        parameters.clearance.interval, parameters.clearance.radius);
    path.push_back({frame->stamp, *frame->trueDistance, distanceToSeen(*frame->load, *frame->cloud),
                    distanceOf(result.clearance), distanceOf(rays)});
    if (!progress(static_cast<double>(index) / static_cast<double>(all))) return {};
  }
  return path;
}

Figure figureOf(const std::string& file, const std::string& title, const std::vector<Place>& path) {
  Figure figure{file,
                title,
                {"time (s): along x, then y, then z", false, {}, {}},
                {"distance (m)", false, 0.0, {}},
                {{"truth", {}, Series::Kind::Line},
                 {"truth of what is seen", {}, Series::Kind::Line},
                 {"exact", {}, Series::Kind::Line},
                 {"rays", {}, Series::Kind::Line}},
                {{1.0, 2.0, "caution"}, {0.0, 1.0, "warning"}},
                {}};
  for (const Place& place : path) {
    figure.series[0].samples.push_back({place.time, place.truth});
    figure.series[1].samples.push_back({place.time, place.seen});
    figure.series[2].samples.push_back({place.time, place.exact});
    figure.series[3].samples.push_back({place.time, place.rays});
  }
  return figure;
}

/// Reported less true distance, over the places where both are known.
void addErrors(Table& table, const char* scene, const char* method,
               std::optional<double> Place::*reported, bool seen, const std::vector<Place>& path) {
  std::vector<double> errors, sizes;
  for (const Place& place : path) {
    const auto truth = seen ? place.seen : std::optional(place.truth);
    if (!truth || !(place.*reported)) continue;
    errors.push_back(*(place.*reported) - *truth);
    sizes.push_back(std::abs(errors.back()));
  }
  table.rows.push_back({scene, method, seen ? "what is seen" : "everything",
                        std::to_string(errors.size()), fixedText(meanOf(errors), 3),
                        fixedText(quantileOf(sizes, 0.5), 3), fixedText(quantileOf(sizes, 0.95), 3),
                        fixedText(quantileOf(sizes, 1.0), 3),
                        fixedText(shareAbove(errors, 0.1), 1, 100.0)});
}

void addAll(Table& table, const char* scene, const std::vector<Place>& path) {
  for (const bool seen : {true, false}) {
    addErrors(table, scene, "exact", &Place::exact, seen, path);
    addErrors(table, scene, "rays", &Place::rays, seen, path);
  }
}

/// A load that is put at one place after the surroundings are known.
std::optional<double> distanceAt(const std::string& demo, const OrientedBox& load,
                                 ClearanceMethod method, const Parameters& given) {
  const auto source = openDemoSource(demo, "demo:" + demo);
  Parameters parameters = given;
  parameters.clearance.method = method;
  parameters.load.source = LoadSource::Scene;
  Pipeline pipeline;
  Result result;
  for (int k = 0; k < 8; ++k) {
    auto frame = std::make_shared<Frame>(*source->next({}).frame);
    frame->load = load;
    if (k < 5) frame->load->centre = {0.0, 0.0, 0.2};
    result = pipeline.process(frame, parameters);
  }
  return distanceOf(result.clearance);
}

Table posesOf(const Parameters& parameters) {
  struct Pose {
    const char* name;
    const char* demo;
    OrientedBox load;
    const char* thesis;
    double truth;
  };
  const std::array poses{Pose{"Fig. 22: in front of all", "cylinders", cylindersInFront(), "0.6",
                              distance(cylindersInFront(), cylindersScene())},
                         Pose{"Fig. 22: inside", "cylinders", cylindersInside(), "0",
                              distance(cylindersInside(), cylindersScene())},
                         Pose{"Fig. 22: past them, to the floor", "cylinders", cylindersPast(),
                              "1.9", distance(cylindersPast(), cylindersScene())},
                         Pose{"Fig. 21: inside the wall", "wall", wallInside(), "0.7",
                              distance(wallInside(), wallScene())}};
  Table table{"simulator_poses",
              "Distances in metres.",
              {"pose", "thesis", "truth", "exact", "rays"},
              {},
              1};
  for (const Pose& pose : poses) {
    table.rows.push_back(
        {pose.name, pose.thesis, fixedText(pose.truth, 2),
         fixedText(distanceAt(pose.demo, pose.load, ClearanceMethod::Exact, parameters), 2),
         fixedText(distanceAt(pose.demo, pose.load, ClearanceMethod::Rays, parameters), 2)});
  }
  return table;
}

}  // namespace

std::optional<Chapter> runSimulatorExperiment(const ExperimentSetup& setup,
                                              const ExperimentProgress& progress) {
  Table poses = posesOf(setup.parameters);
  if (!progress(0.1)) return std::nullopt;
  constexpr std::size_t usual = 300;  // places a path
  const std::size_t stride = 600 / setup.share(usual);
  const auto cylinders = pathOf("cylinders", stride, setup.parameters,
                                [&](double share) { return progress(0.1 + 0.45 * share); });
  if (cylinders.empty()) return std::nullopt;
  const auto wall = pathOf("wall", stride, setup.parameters,
                           [&](double share) { return progress(0.55 + 0.45 * share); });
  if (wall.empty()) return std::nullopt;
  Table errors{"simulator_errors",
               "Reported less true distance along the whole path, metres; |error| by quantile, and "
               "percent of places with more than 10 cm too much.",
               {"scene", "method", "against", "places", "bias", "50 %", "95 %", "largest",
                "> 10 cm too far (%)"},
               {},
               3};
  addAll(errors, "cylinders", cylinders);
  addAll(errors, "wall", wall);
  return Chapter{
      "Fig. 21 and 22: the simulator",
      {"The thesis measured three poses among cylinders, and one inside a wall that is seen from "
       "its end. Here they are, and the whole path of the load along x, y and z.",
       std::move(poses),
       figureOf("simulator_cylinders", "Among the cylinders (Fig. 22)", cylinders),
       "The limit of the wall: it is parallel to the optical axis, the camera sees its gable only, "
       "and the distance to the gable is all that a 2.5-D model can tell. Inside the wall the "
       "truth "
       "is 0; that the volume behind the gable was never observed is in the observed share, not in "
       "the distance.",
       figureOf("simulator_wall", "Beside and behind the gable of a wall (Fig. 21)", wall),
       std::move(errors)}};
}

}  // namespace boomwatch
