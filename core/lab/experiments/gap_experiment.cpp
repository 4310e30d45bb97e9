#include "lab/experiments/experiments.h"

#include <opencv2/imgproc.hpp>

#include "lab/experiments/model_picture.h"
#include "simulation/scene_view.h"

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

EnvironmentModel modelOf(const Cloud& cloud, const ModelParameters& parameters,
                         ModelProjection projection) {
  EnvironmentModel model(GridGeometry({-2, 2, -2, 2, 0, 5}, parameters.resolution, projection));
  for (int frame = 0; frame < frames; ++frame) model.update(cloud.points, parameters);
  return model;
}

cv::Mat sized(const cv::Mat& picture) {
  cv::Mat large;
  const int width = 400 * picture.cols / picture.rows;
  cv::resize(picture, large, {width, 400}, 0, 0, cv::INTER_NEAREST);
  return large;
}

/// Width, on the wall, of what was never observed beside a box at `z`, in the row through its
/// middle, as far as the picture and the bounds go.
double gapIn(const EnvironmentModel& model, double z) {
  const GridGeometry& geometry = model.geometry();
  const double onWall = geometry.toPlane(wallZ), onBox = geometry.toPlane(z);
  const int row = geometry.rowOf(0.1 * onBox);
  const int last = std::min(geometry.columns() - 1, geometry.columnOf(2.0 * onWall));
  int never = 0;
  for (int column = geometry.columnOf(boxLeft * onBox); column <= last; ++column) {
    never += model.state(column, row) == CellState::NeverObserved;
  }
  return never * geometry.resolution() / onWall;
}

/// From the box's far edge, as the model has it, to where the ray past that edge meets the wall. On
/// the near side the box covers what it hides; and along rays nothing else is hidden at all.
double expectedGap(double z, ModelProjection projection) {
  const double edge = boxLeft + boxWidth;
  if (projection == ModelProjection::Perspective) return 0.0;
  return std::min(edge * wallZ / z, 2.0) - edge;
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
                  "As in Fig. 17: what the camera sees (left), the environment model of parallel "
                  "columns (middle), and of rays (right); nearer is brighter, stripes were never "
                  "observed. The box at 1.5 m.",
                  {}};
  constexpr double places[] = {1.5, 2.0, 2.5, 3.0, 3.5};
  constexpr std::pair<ModelProjection, const char*> projections[] = {
      {ModelProjection::Parallel, "parallel (the thesis's)"},
      {ModelProjection::Perspective, "perspective"}};
  std::vector<cv::Mat> pictures;
  std::size_t done = 0;
  for (const double z : places) {
    const SceneView view = lookAt(sceneWithBoxAt(z));
    for (const auto& [projection, name] : projections) {
      const EnvironmentModel model = modelOf(*view.cloud, setup.parameters.model, projection);
      table.rows.push_back({name, fixedText(z, 1), fixedText(expectedGap(z, projection), 2),
                            fixedText(gapIn(model, z), 2)});
      if (done == 0) pictures.push_back(sized(modelPicture(model)));
    }
    if (done == 0) {
      cv::Mat seen;
      cv::resize(view.image, seen, {533, 400}, 0, 0, cv::INTER_AREA);
      picture.image = besideEachOther(seen, besideEachOther(pictures[0], pictures[1]));
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
