#include "lab/experiments/experiments.h"

#include <array>
#include <cmath>

#include "environment/cell_update.h"
#include "lab/experiments/update_rule.h"

namespace boomwatch {
namespace {

constexpr int longEnough = 400;  // frames

/// A cell that is measured in every frame, or in none.
class Cell {
 public:
  /// Frames until it is, or is no longer, occupied; absent when that never comes.
  std::optional<int> framesUntil(bool occupied, bool measured, const ModelParameters& parameters) {
    for (int frame = 1; frame <= longEnough; ++frame) {
      m_nearness = measured ? 1 : 0;
      updateCells({&m_probability, 1}, {&m_level, 1}, {&m_nearness, 1}, parameters);
      if ((m_level > 0) == occupied) return frame;
    }
    return std::nullopt;
  }

 private:
  float m_probability = 0.0F;
  std::uint8_t m_level = 0;
  std::uint8_t m_nearness = 0;
};

std::string text(std::optional<int> frames) { return frames ? std::to_string(*frames) : "never"; }

/// Eq. (23), solved for n.
std::optional<int> byEquation(const ModelParameters& p) {
  const double reached = p.probtresh * (1.0 - p.pPost) / p.pPrior;
  if (reached >= 1.0) return std::nullopt;
  return static_cast<int>(std::floor(std::log(1.0 - reached) / std::log(p.pPost))) + 1;
}

struct Line {
  std::optional<int> enter, leave;
};

/// After it was seen for long, in how many frames without it a cell leaves.
Line lineOf(const ModelParameters& parameters) {
  if (parameters.update == ModelUpdate::Hysteresis &&
      parameters.probtresh <= parameters.leaveThreshold) {
    return {};
  }
  Cell cell;
  Line line;
  line.enter = cell.framesUntil(true, true, parameters);
  if (!line.enter) return line;
  cell.framesUntil(false, true, parameters);
  line.leave = cell.framesUntil(false, false, parameters);
  return line;
}

}  // namespace

std::optional<Chapter> runEntryExperiment(const ExperimentSetup& setup,
                                          const ExperimentProgress& progress) {
  Table table{"frames_to_enter",
              "Frames in a row until a thing enters the model, and frames without it until one "
              "that was seen for long leaves, counted on the model itself.",
              {"probtresh", "Eq. 23", "thesis enters", "leaves", "hysteresis enters", "leaves",
               "log_odds enters", "leaves"},
              {},
              1};
  Figure figure{"frames_to_enter",
                "Frames in a row that a thing must be seen to enter the model",
                {"probtresh", false, 0.0, 1.0},
                {"frames", false, 0.0, {}},
                {},
                {},
                {}};
  for (const UpdateRule& rule : updateRules)
    figure.series.push_back({rule.name, {}, Series::Kind::Marked});
  ModelParameters parameters = setup.parameters.model;
  for (int step = 1; step < 20; ++step) {
    parameters.probtresh = step * 0.05;
    parameters.update = ModelUpdate::Thesis;
    Cells row{fixedText(parameters.probtresh, 2), text(byEquation(parameters))};
    for (std::size_t k = 0; k < updateRules.size(); ++k) {
      parameters.update = updateRules[k].update;
      const Line line = lineOf(parameters);
      row.push_back(text(line.enter));
      row.push_back(line.enter ? text(line.leave) : "");
      figure.series[k].samples.push_back({parameters.probtresh, line.enter});
    }
    table.rows.push_back(std::move(row));
    if (!progress(step / 19.0)) return std::nullopt;
  }
  return Chapter{"Eq. 22-23: frames to enter the model",
                 {"The thesis: with p_prior 0.2, p_post 0.7 and probtresh 0.5 a thing must be seen "
                  "in n >= 4 successive frames. No distance enters above 2/3, ever. The price of "
                  "this update is in the column *leaves*: a single frame without it is enough at "
                  "0.5.",
                  std::move(table), std::move(figure)}};
}

}  // namespace boomwatch
