#include "collision/depth_pyramid.h"

#include <algorithm>

namespace boomwatch {
namespace {

constexpr int fan = DepthPyramid::fan;

int blocksFor(int cells) { return (cells + fan - 1) / fan; }

// Both loops run over neighbouring bytes without a branch, so that the compiler vectorises them.
// `neutral` fills up a last block that is not whole.
template <class Pick>
void shrink(const std::uint8_t* in, int columns, int rows, std::vector<std::uint8_t>& out,
            std::uint8_t neutral, Pick pick) {
  const int outColumns = blocksFor(columns);
  out.resize(static_cast<std::size_t>(outColumns) * static_cast<std::size_t>(blocksFor(rows)));
  std::vector<std::uint8_t> lineBuffer(static_cast<std::size_t>(outColumns * fan), neutral);
  std::uint8_t* line = lineBuffer.data();
  for (int top = 0; top < rows; top += fan) {
    const std::uint8_t* row = in + static_cast<std::size_t>(top) * columns;
    std::copy_n(row, columns, line);
    for (int r = top + 1; r < std::min(top + fan, rows); ++r) {
      row += columns;
      for (int i = 0; i < columns; ++i) line[i] = pick(line[i], row[i]);
    }
    std::uint8_t* target = out.data() + static_cast<std::size_t>(top / fan) * outColumns;
    for (std::ptrdiff_t i = 0; i < outColumns; ++i) {
      const std::uint8_t* four = line + fan * i;
      target[i] = pick(pick(four[0], four[1]), pick(four[2], four[3]));
    }
  }
}

void shrink(const DepthPyramid::Floor& lower, const std::uint8_t* farthest,
            DepthPyramid::Floor& upper) {
  upper.columns = blocksFor(lower.columns);
  upper.rows = blocksFor(lower.rows);
  const auto smaller = [](std::uint8_t a, std::uint8_t b) { return a < b ? a : b; };
  const auto larger = [](std::uint8_t a, std::uint8_t b) { return a > b ? a : b; };
  shrink(lower.nearest.data(), lower.columns, lower.rows, upper.nearest, DepthPyramid::empty,
         smaller);
  shrink(farthest, lower.columns, lower.rows, upper.farthest, 0, larger);
}

// At least one floor of blocks stands on the cells, so that every search begins with a block.
std::size_t floorCount(int columns, int rows) {
  std::size_t count = 1;
  do {
    columns = blocksFor(columns);
    rows = blocksFor(rows);
    ++count;
  } while (columns > 1 || rows > 1);
  return count;
}

void fillUnseen(std::span<const float> probabilities, std::vector<std::uint8_t>& levels) {
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (levels[k] == 0 && !(probabilities[k] > 0.0F)) levels[k] = 1;
  }
}

}  // namespace

void DepthPyramid::rebuild(const EnvironmentModel& model, std::span<const std::size_t> without,
                           bool solid) {
  m_geometry = model.geometry();
  m_solid = solid;
  std::span<const std::uint8_t> levels = model.levels();
  if (levels.empty()) {
    m_floors.clear();
    return;
  }
  if (solid || !without.empty()) {
    m_farthest.assign(levels.begin(), levels.end());
    if (solid) fillUnseen(model.probabilities(), m_farthest);
    for (const std::size_t k : without) m_farthest[k] = 0;
    levels = m_farthest;
  }
  m_floors.resize(floorCount(m_geometry.columns(), m_geometry.rows()));
  Floor& cells = m_floors.front();
  cells.columns = m_geometry.columns();
  cells.rows = m_geometry.rows();
  cells.nearest.resize(levels.size());
  std::transform(levels.begin(), levels.end(), cells.nearest.begin(),
                 [](std::uint8_t level) { return static_cast<std::uint8_t>(level - 1); });
  for (std::size_t n = 1; n < m_floors.size(); ++n) {
    const std::uint8_t* farthest = n == 1 ? levels.data() : m_floors[n - 1].farthest.data();
    shrink(m_floors[n - 1], farthest, m_floors[n]);
  }
}

}  // namespace boomwatch
