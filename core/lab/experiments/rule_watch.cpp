#include "lab/experiments/rule_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "simulation/demo_camera.h"
#include "simulation/yard/yard_truth.h"

namespace boomwatch {
namespace {

constexpr int settled = 20;   // frames after which flicker is no longer the beginning
constexpr int longVisit = 4;  // frames: shorter ones cannot enter by Eq. 23

bool isCrane(YardKind kind) {
  return kind == YardKind::Crane || kind == YardKind::Tool || kind == YardKind::Load;
}

/// 0 is nothing, and nearer wins.
void nearer(std::uint8_t& best, std::uint8_t level) {
  if (best == 0 || level < best) best = level;
}

bool isAbout(int a, int b) { return std::abs(a - b) <= CellTruth::tolerance; }

}  // namespace

CellTruth::CellTruth(const GridGeometry& geometry, const YardTruth& yard)
    : m_geometry(geometry),
      m_standing(geometry.cellCount()),
      m_moving(geometry.cellCount()),
      m_near(geometry.cellCount()),
      m_far(geometry.cellCount()) {
  for (int v = 0; v < yard.depth.rows; ++v) {
    for (int u = 0; u < yard.depth.cols; ++u) {
      const auto kind = YardKind{yard.kind.at<std::uint8_t>(v, u)};
      const auto z = static_cast<double>(yard.depth.at<float>(v, u));
      if (kind == YardKind::Nothing || isCrane(kind) || !std::isfinite(z)) continue;
      const Eigen::Vector3d p = z * demoCamera.ray(u, v);
      if (!geometry.bounds().contains(p.cast<float>())) continue;
      const Eigen::Vector2d q = geometry.onPlane(p);
      const int column = geometry.columnOf(q.x()), row = geometry.rowOf(q.y());
      if (!geometry.contains(column, row)) continue;
      const std::size_t k = geometry.index(column, row);
      const std::uint8_t level = geometry.levelOf(z);
      nearer(moves(kind) ? m_moving[k] : m_standing[k], level);
      nearer(m_near[k], level);
      m_far[k] = std::max(m_far[k], level);
    }
  }
}

bool CellTruth::isSeenAround(int column, int row) const {
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      if (m_geometry.contains(i, j) && m_near[m_geometry.index(i, j)] > 0) return true;
    }
  }
  return false;
}

bool CellTruth::isTrue(int column, int row, int level) const {
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      if (!m_geometry.contains(i, j)) continue;
      const std::size_t k = m_geometry.index(i, j);
      if (m_near[k] > 0 && level >= m_near[k] - tolerance && level <= m_far[k] + tolerance) {
        return true;
      }
    }
  }
  return false;
}

RuleWatch::RuleWatch(const GridGeometry& geometry)
    : m_seen(geometry.cellCount()),
      m_changes(geometry.cellCount()),
      m_occupied(geometry.cellCount()),
      m_visits(geometry.cellCount()),
      m_geometry(geometry) {}

void RuleWatch::look(const EnvironmentModel& model, const CellTruth& truth,
                     const std::vector<bool>& hidden) {
  int wrong = 0, moving = 0;
  const bool judged = m_frames >= settled;
  for (int row = 0; row < m_geometry.rows(); ++row) {
    for (int column = 0; column < m_geometry.columns(); ++column) {
      const std::size_t k = m_geometry.index(column, row);
      const int level = model.levels()[k];
      const bool occupied = level > 0;
      if (judged) {
        m_seen[k] += truth.standing(k) > 0 && truth.moving(k) == 0 && !hidden[k];
        m_changes[k] += occupied != m_occupied[k];
        wrong += occupied && !hidden[k] && truth.isSeenAround(column, row) &&
                 !truth.isTrue(column, row, level);
        moving += occupied && truth.moving(k) > 0 && isAbout(level, truth.moving(k)) &&
                  !isAbout(level, truth.standing(k));
      }
      m_occupied[k] = occupied;
      // Where it stands right before something that has its place, the two cannot be told apart.
      const bool apart = truth.moving(k) > 0 &&
                         (truth.standing(k) == 0 || !isAbout(truth.moving(k), truth.standing(k)));
      follow(m_visits[k], apart ? truth.moving(k) : 0, level, hidden[k]);
    }
  }
  ++m_frames;
  if (!judged) return;
  m_figures.falseCells.push_back(wrong);
  m_figures.movingCells.push_back(moving);
}

void RuleWatch::follow(Visit& visit, int truth, int level, bool hidden) {
  if (hidden) {
    visit = {};
    return;
  }
  if (truth > 0) {
    ++visit.since;
    visit.level = truth;
    visit.leaving = 0;
    m_figures.visits += visit.since == longVisit;
    if (!visit.shown && level > 0 && isAbout(level, truth)) {
      visit.shown = true;
      m_figures.latencyIn.push_back(visit.since);
    }
    return;
  }
  if (visit.shown) {
    ++visit.leaving;
    if (level > 0 && isAbout(level, visit.level)) return;
    m_figures.latencyOut.push_back(visit.leaving);
  }
  visit = {};
}

void RuleWatch::addTo(Figures& figures) const {
  const int judged = m_frames - settled;
  for (std::size_t k = 0; judged > 0 && k < m_seen.size(); ++k) {
    if (m_seen[k] == judged) figures.flicker.push_back(100.0 * m_changes[k] / judged);
  }
  const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(figures.latencyIn, m_figures.latencyIn);
  append(figures.latencyOut, m_figures.latencyOut);
  append(figures.falseCells, m_figures.falseCells);
  append(figures.movingCells, m_figures.movingCells);
  figures.visits += m_figures.visits;
}

}  // namespace boomwatch
