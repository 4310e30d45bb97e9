#include "load/depth_patch.h"

#include <algorithm>
#include <limits>

#include "base/median.h"
#include "load/load_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Vector3f;

constexpr LoadTuning::Patch tuning;

constexpr int finestHalfSide = 75, coarsestHalfSide = 20;
constexpr double minPerCell = 2.5;
constexpr float nearest = 0.02F, farthest = 1e6F;  ///< metres; nothing is measured beyond

/// Calls `take` with every `thinning`-th measured point (a power of 2), evenly over both
/// directions.
template <class Take>
void forPoints(const Cloud& cloud, int thinning, Take&& take) {
  int step = 1;
  while (4 * step * step <= thinning) step *= 2;
  const bool quincunx = step * step < thinning;
  // What is not organised has no second direction.
  const int across = cloud.organised() ? (quincunx ? 2 * step : step) : thinning;
  for (int row = 0, k = 0; row < cloud.height; row += step, ++k) {
    const Vector3f* const points =
        cloud.points.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(cloud.width);
    for (int column = quincunx && k % 2 == 1 ? step : 0; column < cloud.width; column += across) {
      const Vector3f& p = points[column];
      // Other coordinates that are no numbers, or infinite, lie outside every grid.
      if (p.z() > tuning.nearest && p.z() < tuning.farthest) take(p);
    }
  }
}

/// Where a direction lies in the grid of a patch; DepthPatch::indexOf, for a million points.
class GridPlace {
 public:
  explicit GridPlace(const DepthPatch& patch)
      : m_side(patch.side),
        m_scale(static_cast<float>(1.0 / patch.cell)),
        m_u(static_cast<float>(-patch.u0 / patch.cell)),
        m_v(static_cast<float>(-patch.v0 / patch.cell)) {}
  int operator()(float u, float v) const {
    const float column = u * m_scale + m_u, row = v * m_scale + m_v;
    const auto side = static_cast<float>(m_side);
    if (!(column >= 0.0F && column < side && row >= 0.0F && row < side)) return -1;
    return static_cast<int>(row) * m_side + static_cast<int>(column);
  }

 private:
  int m_side;
  float m_scale, m_u, m_v;
};

/// How many points there are in a cell that has any, from every 16th.
double density(const Cloud& cloud, DepthPatch& patch) {
  constexpr int thinning = 16;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  patch.uMin = patch.vMin = infinity;
  patch.uMax = patch.vMax = -infinity;
  std::vector<char> coarse(static_cast<std::size_t>(patch.side) * patch.side / 16 + patch.side);
  double count = 0.0, occupied = 0.0;
  const GridPlace place(patch);
  forPoints(cloud, thinning, [&](const Vector3f& p) {
    const float u = p.x() / p.z(), v = p.y() / p.z();
    if (!(std::isfinite(u) && std::isfinite(v))) return;
    patch.uMin = std::min<double>(patch.uMin, u), patch.uMax = std::max<double>(patch.uMax, u);
    patch.vMin = std::min<double>(patch.vMin, v), patch.vMax = std::max<double>(patch.vMax, v);
    const int index = place(u, v);
    if (index < 0) return;
    ++count;
    const int block = (index / patch.side / 4) * (patch.side / 4 + 1) + index % patch.side / 4;
    char& seen = coarse[static_cast<std::size_t>(block)];
    occupied += seen == 0 ? 16.0 : 0.0;  // a block is 4 x 4 cells
    seen = 1;
  });
  return occupied > 0.0 ? count * thinning / occupied : 0.0;
}

struct Placed {
  int cell;
  DepthPatch::Sample sample;
};

void sortIntoCells(DepthPatch& patch, const std::vector<Placed>& placed) {
  const auto cells = static_cast<std::size_t>(patch.side) * static_cast<std::size_t>(patch.side);
  patch.begin.assign(cells + 1, 0);
  for (const Placed& p : placed) ++patch.begin[static_cast<std::size_t>(p.cell) + 1];
  for (std::size_t i = 0; i < cells; ++i) patch.begin[i + 1] += patch.begin[i];
  patch.samples.resize(placed.size());
  std::vector<std::size_t> next(patch.begin.begin(), patch.begin.end() - 1);
  for (const Placed& p : placed) patch.samples[next[static_cast<std::size_t>(p.cell)]++] = p.sample;
}

void takeMedians(DepthPatch& patch) {
  constexpr double medianOverMean = 1.25;  // of a normal distribution's standard errors
  const std::size_t cells = patch.begin.size() - 1;
  patch.q.assign(cells, std::numeric_limits<float>::quiet_NaN());
  patch.sigma.assign(cells, 0.0F);
  std::vector<float> values;
  for (std::size_t i = 0; i < cells; ++i) {
    const std::size_t count = patch.begin[i + 1] - patch.begin[i];
    if (count == 0) continue;
    values.resize(count);
    for (std::size_t k = 0; k < count; ++k) values[k] = patch.samples[patch.begin[i] + k].q;
    patch.q[i] = medianOf(values);
    const double factor = count > 2 ? medianOverMean / std::sqrt(double(count)) : 1.0;
    patch.sigma[i] = static_cast<float>(patch.noise * factor);
  }
}

/// From the cells that are full: those with samples all around.
double samplePitch(const DepthPatch& patch) {
  double count = 0.0, cells = 0.0;
  const auto has = [&](int index) { return !std::isnan(patch.q[static_cast<std::size_t>(index)]); };
  for (int row = 1; row + 1 < patch.side; ++row) {
    for (int column = 1; column + 1 < patch.side; ++column) {
      const int i = row * patch.side + column;
      if (!has(i) || !has(i - 1) || !has(i + 1) || !has(i - patch.side) || !has(i + patch.side)) {
        continue;
      }
      const auto k = static_cast<std::size_t>(i);
      count += static_cast<double>(patch.begin[k + 1] - patch.begin[k]);
      ++cells;
    }
  }
  return cells > 0.0 ? patch.cell * std::sqrt(cells / count) : patch.cell;
}

/// Lays the grid around the tool, in cells of `reach / halfSide` metres there.
void layGrid(DepthPatch& patch, const Vector3f& tool, double reach, int halfSide) {
  patch.side = 2 * halfSide + 1;
  patch.cell = reach / tool.z() / halfSide;
  patch.u0 = tool.x() / tool.z() - patch.side / 2.0 * patch.cell;
  patch.v0 = tool.y() / tool.z() - patch.side / 2.0 * patch.cell;
}

}  // namespace

DepthPatch patchAround(const Cloud& cloud, const Vector3f& tool, double reach, double noise,
                       double samplesPerCell) {
  DepthPatch patch;
  if (!isMeasured(tool) || tool.z() <= tuning.nearest) return patch;
  patch.noise = noise;
  layGrid(patch, tool, reach, tuning.finestHalfSide);
  const double perCell = density(cloud, patch);
  // Where points are sparse, cells that are too fine would tear a surface.
  if (perCell < tuning.minPerCell) {
    const int half =
        static_cast<int>(tuning.finestHalfSide * std::sqrt(perCell / tuning.minPerCell));
    layGrid(patch, tool, reach, std::max(half, tuning.coarsestHalfSide));
  }
  int thinning = 1;
  while (thinning < tuning.maxThinning && 2 * thinning * samplesPerCell <= perCell) thinning *= 2;
  std::vector<Placed> placed;
  placed.reserve(cloud.size() / static_cast<std::size_t>(2 * thinning) + 1);
  const GridPlace place(patch);
  forPoints(cloud, thinning, [&](const Vector3f& p) {
    const float q = 1.0F / p.z(), u = p.x() * q, v = p.y() * q;
    const int index = place(u, v);
    if (index >= 0) placed.push_back({index, {u, v, q}});
  });
  if (placed.empty()) return patch;
  sortIntoCells(patch, placed);
  takeMedians(patch);
  patch.pitch = samplePitch(patch);
  return patch;
}

}  // namespace boomwatch
