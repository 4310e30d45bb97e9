#include "load/cylinder_ends.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr double roughness = 0.03;  ///< metres by which a log is no cylinder
constexpr double slack = 0.05;      ///< metres by which a whole slice may lie behind it

/// What the camera sees in a slice across the cylinder, along its near line.
struct Slice {
  int on = 0, behind = 0, before = 0;
  double sum = 0.0;  ///< of (q - expected q) of those on it
  double farthest = 0.0;
  bool inTool = false;
};

enum class SliceKind { On, Ended, Covered, Empty };

struct Slices {
  double begin = 0.0, width = 0.0;
  std::vector<Slice> slices;
  double middle(std::size_t i) const { return begin + (static_cast<double>(i) + 0.5) * width; }
};

/// Stray measurements among others do not count.
SliceKind kindOf(const Slice& slice, double noise, double allowed) {
  const int seen = slice.on + slice.behind + slice.before;
  if (seen == 0) return SliceKind::Empty;
  if (slice.before > slice.on && slice.before > slice.behind) return SliceKind::Covered;
  if (slice.on <= slice.behind) return SliceKind::Ended;
  const double mean = slice.sum / slice.on;
  // Where the flat end faces the camera, it leaves the round surface backwards.
  return mean < -(3.0 * noise / std::sqrt(double(slice.on)) + allowed) ? SliceKind::Ended
                                                                       : SliceKind::On;
}

constexpr double inner = 0.6;  ///< of the half width that is looked at; an edge has little depth

/// The cells that may lie on the inner part, whatever their depth.
std::vector<int> cellsAlong(const DepthPatch& patch, const CylinderFrame& frame,
                            const ViewedCylinder& cylinder, const CylinderOutline& outline) {
  std::vector<int> cells;
  for (int cell = 0; cell < patch.side * patch.side; ++cell) {
    const auto k = static_cast<std::size_t>(cell);
    if (patch.begin[k] == patch.begin[k + 1]) continue;
    const auto column = static_cast<float>(cell % patch.side);
    const auto row = static_cast<float>(cell / patch.side);
    const CylinderFrame::Seen seen = frame.look(DepthPatch::Sample{
        static_cast<float>(patch.u0) + (column + 0.5F) * static_cast<float>(patch.cell),
        static_cast<float>(patch.v0) + (row + 0.5F) * static_cast<float>(patch.cell), 1.0F});
    const double half = (outline.edge(seen.u, true) - outline.edge(seen.u, false)) / 2.0;
    if (std::abs(seen.v - cylinder.axisV(seen.u)) < inner * half + 2.0 * patch.cell) {
      cells.push_back(cell);
    }
  }
  return cells;
}

void addTo(Slices& cutting, const CylinderFrame::Seen& seen, double noise,
           const ViewedCylinder& cylinder, const CylinderOutline& outline) {
  const double place = (seen.u - cutting.begin) / cutting.width;
  if (!(place >= 0.0 && place < static_cast<double>(cutting.slices.size()))) return;
  const double half = (outline.edge(seen.u, true) - outline.edge(seen.u, false)) / 2.0;
  if (std::abs(seen.v - cylinder.axisV(seen.u)) > inner * half) return;
  Slice& slice = cutting.slices[static_cast<std::size_t>(place)];
  const double expected = outline.q(seen.u, seen.v), off = seen.q - expected;
  const double gate = 3.5 * noise + roughness * expected * expected;
  if (off > gate) {
    ++slice.before;
  } else if (off < -gate) {
    ++slice.behind;
  } else {
    ++slice.on;
    slice.sum += off;
  }
}

Slices cut(const DepthPatch& patch, const CylinderFrame& frame, const ViewedCylinder& cylinder,
           const Vector3d& tool, double toolRadius) {
  const CylinderOutline outline(cylinder);
  Slices cutting;
  cutting.width = std::max(2.0 * patch.pitch, patch.cell / 3.0);
  const double reach = 1.5 * patch.side * patch.cell;
  cutting.begin = -reach;
  cutting.slices.resize(static_cast<std::size_t>(2.0 * reach / cutting.width) + 1);
  for (std::size_t i = 0; i < cutting.slices.size(); ++i) {
    const double u = cutting.middle(i), q = cylinder.axisQ(u);
    if (q <= 0.0) continue;
    const Vector3d p = Vector3d(1.0, u, cylinder.axisV(u)) / q;
    cutting.slices[i].inTool = (p - tool).norm() < toolRadius;
  }
  for (const int cell : cellsAlong(patch, frame, cylinder, outline)) {
    const auto k = static_cast<std::size_t>(cell);
    for (std::size_t i = patch.begin[k]; i < patch.begin[k + 1]; ++i) {
      addTo(cutting, frame.look(patch.samples[i]), patch.noise, cylinder, outline);
    }
  }
  return cutting;
}

/// Whether the camera sees so far to the side, with a little room.
bool inPicture(const DepthPatch& patch, const CylinderFrame& frame, const Vector3d& local) {
  const Vector3d p = frame.toCamera(local);
  const double u = p.x() / p.z(), v = p.y() / p.z(), room = 2.0 * patch.cell;
  return p.z() > 0.0 && u > patch.uMin + room && u < patch.uMax - room && v > patch.vMin + room &&
         v < patch.vMax - room && patch.indexOf(u, v) >= 0;
}

struct Followed {
  double u = 0.0;
  bool seen = false;
  int on = 0, ended = 0;
};

/// Walks from slice `from` in steps of `step`; the tool itself hides what it holds.
Followed follow(const Slices& cutting, const DepthPatch& patch, const CylinderFrame& frame,
                const ViewedCylinder& cylinder, std::ptrdiff_t from, int step) {
  const auto count = static_cast<std::ptrdiff_t>(cutting.slices.size());
  const auto longest = static_cast<int>(std::ceil(7.0 * patch.cell / cutting.width));
  const auto shortest = static_cast<int>(std::ceil(1.5 * patch.cell / cutting.width)) + 1;
  Followed end{cutting.middle(static_cast<std::size_t>(from)), false, 0, 0};
  int covered = 0, empty = 0, ended = 0, endedInAll = 0;
  for (std::ptrdiff_t i = from; i >= 0 && i < count; i += step) {
    const Slice& slice = cutting.slices[static_cast<std::size_t>(i)];
    if (slice.inTool) continue;
    const double q = cylinder.axisQ(cutting.middle(static_cast<std::size_t>(i)));
    if (q <= 0.0) break;
    const SliceKind kind = kindOf(slice, patch.noise, slack * q * q);
    if (kind == SliceKind::On) {
      end.u = cutting.middle(static_cast<std::size_t>(i)) + step * cutting.width / 2.0;
      covered = empty = ended = 0;
      ++end.on;
      end.ended = endedInAll;
    } else if (kind == SliceKind::Ended) {
      ++endedInAll;
      if (++ended >= shortest) {
        end.seen = covered < shortest;
        return end;
      }
    } else if (kind == SliceKind::Covered) {
      if (++covered >= longest) return end;
    } else if (++empty >= longest) {
      // Before a sky that gives no depth an end is seen as well; beside the picture it is not.
      const double u = cutting.middle(static_cast<std::size_t>(i));
      end.seen = covered < shortest && inPicture(patch, frame, Vector3d(1.0, u, cylinder.axisV(u)));
      return end;
    }
  }
  return end;
}

}  // namespace

double CylinderEnds::alongAxis(const ViewedCylinder& cylinder, double u) {
  const Vector3d axis = cylinder.direction(), a = cylinder.pointA();
  const Vector3d away = a - axis * axis.dot(a);
  const Vector3d nearLine = a - away.normalized() * cylinder.radius();
  return (u * nearLine[0] - nearLine[1]) / (axis[1] - u * axis[0]);
}

CylinderEnds findEnds(const DepthPatch& patch, const CylinderFrame& frame,
                      const ViewedCylinder& cylinder, const Vector3d& tool, double toolRadius) {
  const Slices cutting = cut(patch, frame, cylinder, tool, toolRadius);
  const double place = (tool[1] / tool[0] - cutting.begin) / cutting.width;
  CylinderEnds ends;
  int on = 0, ended = 0, all = 0;
  if (!(place >= 0.0 && place < static_cast<double>(cutting.slices.size()))) return ends;
  const auto from = static_cast<std::ptrdiff_t>(place);
  for (const int side : {0, 1}) {
    const Followed end = follow(cutting, patch, frame, cylinder, from, side == 0 ? -1 : 1);
    ends.u[static_cast<std::size_t>(side)] = end.u;
    ends.seen[static_cast<std::size_t>(side)] = end.seen;
    on += end.on;
    ended += end.ended;
  }
  for (std::size_t i = 0; i < cutting.slices.size(); ++i) {
    const double u = cutting.middle(i);
    if (u > ends.u[0] && u < ends.u[1] && !cutting.slices[i].inTool) ++all;
  }
  ends.filled = all > 0 ? static_cast<double>(on) / all : 0.0;
  ends.through = all > 0 ? static_cast<double>(ended) / all : 1.0;
  return ends;
}

}  // namespace boomwatch
