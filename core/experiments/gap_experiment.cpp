#include "experiments/gap_experiment.h"

#include <opencv2/imgproc.hpp>

#include "experiments/model_picture.h"
#include "simulation/pinhole_view.h"

namespace boomwatch {
namespace {

constexpr double wallZ = 4.0;
constexpr double boxWidth = 0.4;
constexpr double boxDepth = 0.3;
constexpr double boxLeft = 0.3;  // beside the axis, so that its gap is on one side
constexpr int frames = 6;        // enough to enter the model, whatever the update

/// A wall, and before it a tall box whose face is at `z`.
Scene sceneWithBoxAt(double z) {
  Scene scene;
  scene.ground.depth = 100.0;  // out of sight
  const OrientedBox wall{{0, 0, wallZ + 0.5}, {12, 8, 1}, Eigen::Matrix3d::Identity()};
  const OrientedBox box{{boxLeft + boxWidth / 2, 0.4, z + boxDepth / 2},
                        {boxWidth, 1.6, boxDepth},
                        Eigen::Matrix3d::Identity()};
  scene.boxes = {wall, box};
  return scene;
}

EnvironmentModel modelOf(const Cloud& cloud, const Parameters& parameters) {
  Bounds bounds = parameters.bounds;
  bounds.xMin = bounds.yMin = -2.0;
  bounds.xMax = bounds.yMax = 2.0;
  bounds.zMin = 0.0;
  bounds.zMax = 5.0;
  EnvironmentModel model(GridGeometry(bounds, parameters.model.resolution));
  for (int frame = 0; frame < frames; ++frame) model.update(cloud.points, parameters.model);
  return model;
}

/// Width in metres of what was never observed, in the row through the box's middle.
double gapIn(const EnvironmentModel& model) {
  const GridGeometry& geometry = model.geometry();
  const int row = geometry.rowOf(0.1);
  int never = 0;
  for (int column = geometry.columnOf(boxLeft); column < geometry.columns(); ++column) {
    never += model.state(column, row) == CellState::NeverObserved;
  }
  return never * geometry.resolution();
}

/// Where the ray past the box's far edge meets the wall, from that edge, as the model sees it. On
/// the near side the box covers what it hides.
double expectedGap(double z) {
  const double edge = boxLeft + boxWidth;
  return edge * wallZ / z - edge;
}

}  // namespace

std::optional<Chapter> runGapExperiment(const ExperimentSetup& setup,
                                        const ExperimentProgress& progress) {
  Table table{"gap_behind_near_objects",
              "Width of the gap beside a box before a wall at 4 m, by the distance of its face.",
              {"model", "box at (m)", "by geometry (m)", "in the model (m)"},
              {},
              1};
  Picture picture{"gap_behind_near_objects",
                  "As in Fig. 17: what the camera sees (left), and the environment model (right); "
                  "nearer is brighter, stripes were never observed. The box at 1.5 m.",
                  {}};
  constexpr double places[] = {1.5, 2.0, 2.5, 3.0, 3.5};
  std::size_t done = 0;
  for (const double z : places) {
    const PinholeView view = lookAt(sceneWithBoxAt(z));
    const EnvironmentModel model = modelOf(*view.cloud, setup.parameters);
    table.rows.push_back({"orthographic (the thesis's)", fixedText(z, 1),
                          fixedText(std::min(expectedGap(z), 2.0 - boxLeft - boxWidth), 2),
                          fixedText(gapIn(model), 2)});
    if (picture.image.empty()) {
      cv::Mat seen, cells;
      cv::resize(view.image, seen, {533, 400}, 0, 0, cv::INTER_AREA);
      cv::resize(modelPicture(model), cells, {400, 400}, 0, 0, cv::INTER_NEAREST);
      picture.image = besideEachOther(seen, cells);
    }
    if (!progress(static_cast<double>(++done) / std::size(places))) return std::nullopt;
  }
  return Chapter{
      "Fig. 17: the gap behind near objects",
      {"The thesis shows the gap and explains it by the perspective of the sensor. In an "
       "orthographic model it is as wide as the shadow on the background beyond the "
       "object's own edge; nothing is known there, which must not be shown as free.",
       std::move(table), std::move(picture)}};
}

}  // namespace boomwatch
