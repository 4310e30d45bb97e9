#include "load/load_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "base/median.h"
#include "load/depth_plane.h"
#include "load/load_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr LoadTuning::Body tuning;

class Growth {
 public:
  Growth(const DepthPatch& patch, const Vector3d& tool, double reach, const Bounds& bounds)
      : m_patch(patch), m_tool(tool), m_reach(reach), m_bounds(bounds) {
    m_free.resize(patch.q.size());
    for (std::size_t i = 0; i < m_free.size(); ++i) {
      m_free[i] = !std::isnan(patch.q[i]) && mayBelong(patch.point(static_cast<int>(i)));
    }
  }

  /// All that hangs together with the cells `from`, which must be open; closes it.
  std::vector<int> grow(std::vector<int> cells, std::vector<char>& open) const {
    for (const int i : cells) open[static_cast<std::size_t>(i)] = 0;
    for (std::size_t next = 0; next < cells.size(); ++next) {
      const int from = cells[next];
      forNeighbours(from, [&](int to) {
        if (open[static_cast<std::size_t>(to)] == 0 || !connected(from, to)) return;
        open[static_cast<std::size_t>(to)] = 0;
        cells.push_back(to);
      });
    }
    return cells;
  }
  void close(int cell) { m_free[static_cast<std::size_t>(cell)] = 0; }
  const std::vector<char>& free() const { return m_free; }

  /// Cells seen within `radius` metres beside the tool, at the tool's depth.
  std::vector<int> around(double radius) const {
    const double u = m_tool.x() / m_tool.z(), v = m_tool.y() / m_tool.z();
    const int cells = std::min(m_patch.side, static_cast<int>(radius / m_tool.z() / m_patch.cell));
    std::vector<int> result;
    for (int dy = -cells; dy <= cells; ++dy) {
      for (int dx = -cells; dx <= cells; ++dx) {
        if (dx * dx + dy * dy > cells * cells) continue;
        const int index = m_patch.indexOf(u + dx * m_patch.cell, v + dy * m_patch.cell);
        if (index >= 0 && m_free[static_cast<std::size_t>(index)] != 0) result.push_back(index);
      }
    }
    return result;
  }

  /// The tool point is one pixel's: the cells around it that are within its noise count.
  std::vector<int> seeds() const {
    constexpr int around = tuning.seedCells;
    const int middle = m_patch.indexOf(m_tool.x() / m_tool.z(), m_tool.y() / m_tool.z());
    std::vector<int> cells;
    if (middle < 0) return cells;
    const double q = 1.0 / m_tool.z();
    const double tolerance =
        LoadTuning::deviations * m_patch.noise + around * m_patch.cell * q * 2.0;
    for (int dy = -around; dy <= around; ++dy) {
      for (int dx = -around; dx <= around; ++dx) {
        const int column = middle % m_patch.side + dx, row = middle / m_patch.side + dy;
        if (column < 0 || row < 0 || column >= m_patch.side || row >= m_patch.side) continue;
        const auto i = static_cast<std::size_t>(row * m_patch.side + column);
        if (m_free[i] != 0 && std::abs(m_patch.q[i] - q) <= tolerance) {
          cells.push_back(static_cast<int>(i));
        }
      }
    }
    return cells;
  }

 private:
  bool mayBelong(const Vector3d& p) const {
    return (p - m_tool).squaredNorm() <= m_reach * m_reach && m_bounds.contains(p.cast<float>());
  }

  template <class Visit>
  void forNeighbours(int cell, Visit&& visit) const {
    const int column = cell % m_patch.side, row = cell / m_patch.side;
    for (int y = std::max(0, row - 1); y <= std::min(m_patch.side - 1, row + 1); ++y) {
      for (int x = std::max(0, column - 1); x <= std::min(m_patch.side - 1, column + 1); ++x) {
        visit(y * m_patch.side + x);
      }
    }
  }

  /// Three cells' width of depth (a surface at 18 degrees to the view), and the noise.
  bool connected(int a, int b) const {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    const double noise = std::hypot(m_patch.sigma[i], m_patch.sigma[j]);
    return std::abs(m_patch.q[i] - m_patch.q[j]) <=
           tuning.steepness * m_patch.cell * m_patch.q[i] + LoadTuning::deviations * noise;
  }

  const DepthPatch& m_patch;
  Vector3d m_tool;
  double m_reach;
  const Bounds& m_bounds;
  std::vector<char> m_free;
};

/// Whether the plane's cells go on to the limit of reach on more than one side, as a ground does
/// and a load or a boom does not.
bool goesOn(const std::vector<Vector3d>& held, const Vector3d& tool, double reach, std::size_t of) {
  if (static_cast<double>(held.size()) < tuning.surfaceShare * static_cast<double>(of))
    return false;
  std::array<int, tuning.sectors> far{};
  for (const Vector3d& p : held) {
    const Vector3d offset = p - tool;
    if (offset.norm() < tuning.surfaceLimit * reach) continue;
    const double turn = std::atan2(offset.y() + offset.z() * 0.5, offset.x()) / (2.0 * M_PI) + 0.5;
    ++far[static_cast<std::size_t>(std::min(turn * tuning.sectors, tuning.sectors - 1.0))];
  }
  return std::count_if(far.begin(), far.end(), [](int n) { return n >= tuning.farCells; }) >=
         tuning.farSectors;
}

/// The plane of `cells` that is ground or wall, if there is one: its cells.
std::vector<int> surfaceIn(const std::vector<int>& cells, const DepthPatch& patch,
                           const Vector3d& tool, double reach, LoadBody& body) {
  if (cells.size() < tuning.minSurface) return {};
  const double thickness = patch.cell * tool.z();
  const auto plane = dominantPlane(patch, cells, thickness);
  if (!plane) return {};
  std::vector<int> held;
  std::vector<Vector3d> points;
  for (const int cell : cells) {
    if (!plane->holds(patch, cell, thickness)) continue;
    held.push_back(cell);
    points.push_back(patch.point(cell));
  }
  if (!goesOn(points, tool, reach, cells.size())) return {};
  body.surfaces.push_back(plane->n.normalized());
  return held;
}

/// Without the noise of its one pixel.
Vector3d steadied(const Vector3d& tool, const std::vector<int>& seeds, const DepthPatch& patch) {
  std::vector<double> values;
  for (const int i : seeds) values.push_back(patch.q[static_cast<std::size_t>(i)]);
  return tool / tool.z() / medianOf(values);
}

}  // namespace

LoadBody growBody(const DepthPatch& patch, const Eigen::Vector3f& tool, const BodyLimits& limits) {
  LoadBody body;
  body.tool = tool.cast<double>();
  Growth growth(patch, body.tool, limits.reach, limits.bounds);
  bool again = true;
  for (int k = 0; again; ++k) {
    again = false;
    const std::vector<int> seeds = growth.seeds();
    if (seeds.empty()) {
      body.fault = k == 0 ? LoadFault::NothingAtTool : LoadFault::OnSurface;
      return body;
    }
    body.tool = steadied(body.tool, seeds, patch);
    std::vector<char> open = growth.free();
    body.cells.clear();
    const auto add = [&](const std::vector<int>& piece) {
      const auto surface = surfaceIn(piece, patch, body.tool, limits.reach, body);
      for (const int cell : surface) growth.close(cell);
      again = again || (!surface.empty() && k < tuning.maxSurfaces);
      if (surface.empty()) body.cells.insert(body.cells.end(), piece.begin(), piece.end());
    };
    add(growth.grow(seeds, open));
    for (const int cell : growth.around(tuning.beside * limits.toolRadius)) {
      if (open[static_cast<std::size_t>(cell)] == 0) continue;
      const auto piece = growth.grow({cell}, open);
      if (piece.size() >= tuning.minPiece) add(piece);
    }
  }
  if (body.cells.empty()) body.fault = LoadFault::OnSurface;
  for (const int cell : body.cells) body.points.push_back(patch.point(cell));
  return body;
}

}  // namespace boomwatch
