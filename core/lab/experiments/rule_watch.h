#pragma once

#include <array>
#include <optional>
#include <vector>

#include "environment/environment_model.h"

namespace boomwatch {

struct YardTruth;  // simulation/yard/yard_truth.h

/// What a frame of demo:yard truly shows in the cells of a model. A depth level of 0: nothing.
class CellTruth {
 public:
  CellTruth(const GridGeometry& geometry, const YardTruth& yard);

  /// The nearest surface of what has its place, and of persons, branches, birds and leaves.
  int standing(std::size_t cell) const { return m_standing[cell]; }
  int moving(std::size_t cell) const { return m_moving[cell]; }
  /// Whether anything but crane and load is seen in the cell or beside it, and whether `level` is
  /// about as deep as something of that.
  bool isSeenAround(int column, int row) const;
  bool isTrue(int column, int row, int level) const;

  /// Levels by which noise and slopes let a cell differ from the truth.
  static constexpr int tolerance = 4;

 private:
  GridGeometry m_geometry;
  std::vector<std::uint8_t> m_standing, m_moving;
  std::vector<std::uint8_t> m_near, m_far;  ///< of all that is seen in the cell; 0: nothing
};

/// How a model's cells behave over a sequence, against the truth.
class RuleWatch {
 public:
  explicit RuleWatch(const GridGeometry& geometry);

  /// After an update with the frame that `truth` is of. `hidden`: cells with crane or load in them.
  void look(const EnvironmentModel& model, const CellTruth& truth, const std::vector<bool>& hidden);

  struct Figures {
    std::vector<double> flicker;    ///< changes per 100 frames, one a cell that is always seen
    std::vector<double> latencyIn;  ///< frames, one a visit of something that moves
    std::vector<double> latencyOut;
    std::size_t visits = 0;           ///< of cells, by something that moves, for 4 frames or more
    std::vector<double> falseCells;   ///< one a frame: occupied where nothing is, of what is seen
    std::vector<double> movingCells;  ///< one a frame: that show something that moves
  };
  /// Adds what was seen; flicker only of cells that were seen in every frame.
  void addTo(Figures& figures) const;

 private:
  struct Visit {
    int since = 0;  ///< frames that something is there; 0: nothing
    int level = 0;  ///< its last depth
    bool shown = false;
    int leaving = 0;  ///< frames since it left while still shown; 0: no longer
  };
  void follow(Visit& visit, int truth, int level, bool hidden);

  std::vector<int> m_seen, m_changes;
  std::vector<bool> m_occupied;
  std::vector<Visit> m_visits;
  int m_frames = 0;
  GridGeometry m_geometry;
  Figures m_figures;
};

}  // namespace boomwatch
