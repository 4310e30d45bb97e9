#include "lab/experiments/experiments.h"

#include <array>
#include <cmath>
#include <numbers>

#include "environment/cell_update.h"
#include "lab/experiments/model_picture.h"
#include "lab/experiments/update_rule.h"
#include "simulation/scene_view.h"
#include "simulation/yard/yard.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr double rate = Yard::rate;
constexpr double walking = 1.1, running = 4.0;  // m/s
constexpr PinholeCamera camera = PinholeCamera::centred(384, 288, 200.0);

OrientedBox upright(const Vector3d& centre, const Vector3d& size) {
  return {centre, size, Eigen::Matrix3d::Identity()};
}

/// What stands there all the time, and something that comes and goes, as one camera sees them.
struct Stage {
  Bounds bounds;
  double resolution = 0.04;
  std::vector<OrientedBox> standing;

  Points seenWith(const std::optional<OrientedBox>& mover) const {
    Scene scene;
    scene.ground.depth = 100.0;  // out of sight
    scene.boxes = standing;
    if (mover) scene.boxes.push_back(*mover);
    return lookAt(scene, camera).cloud->points;
  }
};

/// The model under each update, and how much of the thing that comes and goes is in it.
class Watchers {
 public:
  Watchers(const Stage& stage, const ModelParameters& parameters)
      : m_stage(stage), m_geometry(stage.bounds, stage.resolution) {
    for (std::size_t k = 0; k < updateRules.size(); ++k) {
      m_models.emplace_back(m_geometry);
      m_parameters[k] = parameters;
      m_parameters[k].update = updateRules[k].update;
    }
  }

  void show(const std::optional<OrientedBox>& mover) {
    const Points points = m_stage.seenWith(mover);
    for (std::size_t k = 0; k < m_models.size(); ++k) m_models[k].update(points, m_parameters[k]);
  }

  /// Share of the cells before which `thing` stands, that show it.
  double shareOf(const OrientedBox& thing, std::size_t rule) const {
    int all = 0, shown = 0;
    const EnvironmentModel& model = m_models[rule];
    forEachCell(thing, [&](int column, int row) {
      ++all;
      shown += showsIt(model, thing, column, row);
    });
    return all > 0 ? static_cast<double>(shown) / all : 0.0;
  }

  const EnvironmentModel& model(std::size_t rule) const { return m_models[rule]; }

 private:
  /// Those that lie wholly behind its face.
  template <class Work>
  void forEachCell(const OrientedBox& thing, Work&& work) const {
    const Vector3d low = thing.centre - thing.size / 2, high = thing.centre + thing.size / 2;
    for (int row = m_geometry.rowOf(low.y()) + 1; row < m_geometry.rowOf(high.y()); ++row) {
      for (int column = m_geometry.columnOf(low.x()) + 1; column < m_geometry.columnOf(high.x());
           ++column) {
        if (m_geometry.contains(column, row)) work(column, row);
      }
    }
  }

  bool showsIt(const EnvironmentModel& model, const OrientedBox& thing, int column, int row) const {
    const int level = model.levels()[m_geometry.index(column, row)];
    const double face = thing.centre.z() - thing.size.z() / 2;
    return level > 0 && std::abs(m_geometry.zOf(level) - face) <= 2.0 * m_geometry.levelStep();
  }

  const Stage& m_stage;
  GridGeometry m_geometry;
  std::vector<EnvironmentModel> m_models;
  std::array<ModelParameters, updateRules.size()> m_parameters;
};

/// Fig. 18: someone goes past, 3 m away.
OrientedBox walker(double way) { return upright({-2.4 + way, 0.2, 3.15}, {0.5, 1.7, 0.3}); }

/// Fig. 19: a sheet of paper, swung in a circle so fast that it is nowhere for long, and then held
/// still in its middle.
constexpr double swingFor = 2.0, heldFor = 1.0;  // seconds
OrientedBox sheet(double time) {
  const double turn = 2.0 * std::numbers::pi * 1.6 * time;
  const double radius = time < swingFor ? 0.3 : 0.0;
  return upright({0.4 + radius * std::cos(turn), -0.2 + radius * std::sin(turn), 0.905},
                 {0.3, 0.21, 0.01});
}

struct Walk {
  double most = 0.0, mean = 0.0;  ///< share of the walker in the model
};

/// Somebody walks past, with or without a wall behind.
std::array<Walk, updateRules.size()> walkPast(const Stage& stage, double speed,
                                              const ModelParameters& parameters, Picture* picture) {
  Watchers watchers(stage, parameters);
  for (int frame = 0; frame < 8; ++frame) watchers.show(std::nullopt);
  std::array<Walk, updateRules.size()> walks;
  const int frames = static_cast<int>(4.8 / speed * rate);
  for (int frame = 0; frame < frames; ++frame) {
    const OrientedBox person = walker(frame / rate * speed);
    watchers.show(person);
    for (std::size_t k = 0; k < updateRules.size(); ++k) {
      const double share = watchers.shareOf(person, k);
      walks[k].most = std::max(walks[k].most, share);
      walks[k].mean += share / frames;
    }
    if (picture && frame == frames / 2) {
      picture->image =
          besideEachOther(modelPicture(watchers.model(0)), probabilityPicture(watchers.model(0)));
    }
  }
  return walks;
}

void addWalk(Table& table, const char* where, const Stage& stage, double speed,
             const ModelParameters& parameters, Picture* picture = nullptr) {
  const auto walks = walkPast(stage, speed, parameters, picture);
  for (std::size_t k = 0; k < updateRules.size(); ++k) {
    table.rows.push_back({where, fixedText(speed, 1), updateRules[k].name,
                          fixedText(walks[k].most, 0, 100.0), fixedText(walks[k].mean, 0, 100.0)});
  }
}

/// Fig. 19's bounds and resolution; somebody stands there, a wall beyond the bounds.
Stage swingStage() {
  return {{-3.2, 3.2, -3.2, 1.6, -0.4, 1.6},
          0.01,
          {upright({0, 0, 5.5}, {20, 20, 1}), upright({-0.3, 0.6, 1.17}, {0.45, 1.0, 0.3}),
           upright({-0.3, -0.1, 1.07}, {0.179, 0.24, 0.2})}};
}

/// What the thesis measures in its figure: cells across the head's face, and its depth.
std::vector<Cells> headRows(const EnvironmentModel& model) {
  const GridGeometry& geometry = model.geometry();
  const int row = geometry.rowOf(-0.15);
  const int level = model.levels()[geometry.index(geometry.columnOf(-0.3), row)];
  int width = 0;
  for (int column = geometry.columnOf(-0.6); column < geometry.columnOf(0.0); ++column) {
    width += std::abs(model.levels()[geometry.index(column, row)] - level) <= 1;
  }
  return {{"width of the head (cells)", "18", std::to_string(width)},
          {"its depth level", "175", std::to_string(level)},
          {"above z_min (m)", "1.37", fixedText(level * geometry.levelStep(), 2)},
          {"from the camera (m)", "0.97", fixedText(geometry.zOf(level), 2)}};
}

struct Swing {
  double whileSwung = 0.0;                ///< largest share of the sheet in the model
  std::optional<int> appeared, vanished;  ///< frames after it stopped, and after it was taken away
};

std::array<Swing, updateRules.size()> swing(const ModelParameters& parameters, Figure& figure,
                                            Table& head) {
  constexpr double most = 0.9, least = 0.1;  // of the sheet: it is there, it is gone
  const Stage stage = swingStage();
  Watchers watchers(stage, parameters);
  std::array<Swing, updateRules.size()> swings;
  const int swung = static_cast<int>(swingFor * rate);
  const int held = swung + static_cast<int>(heldFor * rate), all = held + 15;
  for (int frame = 0; frame < all; ++frame) {
    const OrientedBox paper = sheet(std::min(frame, held) / rate);
    watchers.show(frame < held ? std::optional(paper) : std::nullopt);
    for (std::size_t k = 0; k < updateRules.size(); ++k) {
      const double share = watchers.shareOf(paper, k);
      Swing& one = swings[k];
      if (frame < swung) one.whileSwung = std::max(one.whileSwung, share);
      // The frame in which it hangs where it will be held is the first in which it is seen there.
      if (frame >= swung && share >= most && !one.appeared) one.appeared = frame - swung + 1;
      if (frame >= held && share <= least && !one.vanished) one.vanished = frame - held + 1;
      figure.series[k].samples.push_back({frame / rate, 100.0 * share});
    }
  }
  head.rows = headRows(watchers.model(0));
  return swings;
}

std::string text(std::optional<int> frames) { return frames ? std::to_string(*frames) : "never"; }

}  // namespace

std::optional<Chapter> runPassingExperiment(const ExperimentSetup& setup,
                                            const ExperimentProgress& progress) {
  const ModelParameters& parameters = setup.parameters.model;
  const Stage open{{-2.5, 2.5, -1.2, 1.2, 0, 6}, 0.04, {upright({0, 0, 9}, {40, 40, 1})}};
  Stage wall = open;
  wall.standing.push_back(upright({0, 0, 5.5}, {10, 10, 1}));
  Table walked{"walking_past",
               "Somebody 0.5 m wide goes past, 3 m away: percent of them in the model.",
               {"behind them", "speed (m/s)", "update", "most (%)", "mean (%)"},
               {},
               1};
  Picture picture{"walking_past",
                  "As in Fig. 18, with nothing behind, the thesis's update: the model (left), the "
                  "probability map with the trail of who walks (right).",
                  {}};
  addWalk(walked, "nothing in the bounds", open, walking, parameters, &picture);
  if (!progress(0.3)) return std::nullopt;
  addWalk(walked, "nothing in the bounds", open, running, parameters);
  if (!progress(0.4)) return std::nullopt;
  addWalk(walked, "a wall at 5 m", wall, walking, parameters);
  if (!progress(0.6)) return std::nullopt;
  addWalk(walked, "a wall at 5 m", wall, running, parameters);
  if (!progress(0.7)) return std::nullopt;

  Table held{"swung_sheet",
             "A sheet is swung for 2 s, held still for 1 s and taken away.",
             {"update", "most of it in the model while swung (%)", "frames to appear (Eq. 23)",
              "frames to appear", "frames until it is gone"},
             {},
             1};
  Table head{"head_in_figure_19", "Fig. 19's measurements.", {"", "thesis", "here"}, {}, 1};
  Figure figure{"swung_sheet",
                "Share of the sheet in the model: swung up to 2 s, held still up to 3 s",
                {"time (s)", false, {}, {}},
                {"share (%)", false, 0.0, 100.0},
                {},
                {},
                {}};
  for (const UpdateRule& rule : updateRules)
    figure.series.push_back({rule.name, {}, Series::Kind::Steps});
  const auto swings = swing(parameters, figure, head);
  for (std::size_t k = 0; k < updateRules.size(); ++k) {
    ModelParameters of = parameters;
    of.update = updateRules[k].update;
    held.rows.push_back({updateRules[k].name, fixedText(swings[k].whileSwung, 0, 100.0),
                         text(framesToEnter(of)), text(swings[k].appeared),
                         text(swings[k].vanished)});
  }
  if (!progress(1.0)) return std::nullopt;
  return Chapter{
      "Fig. 18 and 19: somebody walks past, a sheet is swung",
      {"The thesis: changing areas are not updated into the model; what is held still for four "
       "frames appears. That holds for what is in no place for four frames, as the sheet. Who "
       "walks "
       "is: at 1.1 m/s and 20 frames a second somebody 0.5 m wide covers a cell for nine frames, "
       "and is in the model but for their leading edge. And where something is behind (a wall, the "
       "ground), the thesis's cell is occupied already, and by Eq. 9 takes over the nearer depth "
       "at once, however fast it moves. The hysteresis lets it wait.",
       std::move(walked), std::move(picture), std::move(held), std::move(figure), std::move(head)}};
}

}  // namespace boomwatch
