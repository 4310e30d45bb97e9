#include "load/log/cylinder_ends.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "load/log/log_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr LogTuning::Ends tuning;

/// What the camera sees in a slice across the cylinder, along its near line.
struct Slice {
  int on = 0, behind = 0, before = 0;
  double sum = 0.0;       ///< of (q - expected q) of those on it
  double expected = 0.0;  ///< how many samples have room there
  double u = 0.0;         ///< its middle
  double q = 0.0;         ///< of the near line
  double along = 0.0;     ///< metres from where it passes the tool
  bool inPicture = false;
};

enum class SliceKind { On, Ended, Covered, Empty };

struct Slices {
  double begin = 0.0, width = 0.0;
  std::vector<Slice> slices;
  double middle(std::size_t i) const { return begin + (static_cast<double>(i) + 0.5) * width; }
};

/// A few stray measurements do not count, among others nor alone.
SliceKind kindOf(const Slice& slice, double noise) {
  const int seen = slice.on + slice.behind + slice.before;
  if (seen < tuning.minSeen * slice.expected || seen == 0) return SliceKind::Empty;
  if (slice.before > slice.on && slice.before > slice.behind) return SliceKind::Covered;
  if (slice.on <= slice.behind) return SliceKind::Ended;
  const double mean = slice.sum / slice.on, allowed = tuning.slack * slice.q * slice.q;
  // Where the flat end faces the camera, it leaves the round surface backwards.
  const double within =
      tuning.meanWithin * noise * std::sqrt(1.0 / slice.on + tuning.shared * tuning.shared);
  return mean < -(within + allowed) ? SliceKind::Ended : SliceKind::On;
}

void addTo(Slices& cutting, const CylinderFrame::Seen& seen, double noise,
           const ViewedCylinder& cylinder, const CylinderOutline& outline) {
  const double place = (seen.u - cutting.begin) / cutting.width;
  if (!(place >= 0.0 && place < static_cast<double>(cutting.slices.size()))) return;
  const double half = (outline.edge(seen.u, true) - outline.edge(seen.u, false)) / 2.0;
  if (std::abs(seen.v - cylinder.axisV(seen.u)) > tuning.inner * half) return;
  Slice& slice = cutting.slices[static_cast<std::size_t>(place)];
  const double expected = outline.q(seen.u, seen.v), off = seen.q - expected;
  const double gate = LogTuning::gate * noise + tuning.roughness * expected * expected;
  if (off > gate) {
    ++slice.before;
  } else if (off < -gate) {
    ++slice.behind;
  } else {
    ++slice.on;
    slice.sum += off;
  }
}

/// Whether the camera sees so far to the side, with a little room.
bool inPicture(const DepthPatch& patch, const CylinderFrame& frame, const Vector3d& local) {
  const Vector3d p = frame.toCamera(local);
  const double u = p.x() / p.z(), v = p.y() / p.z(), room = patch.cell;
  return p.z() > 0.0 && u > patch.uMin + room && u < patch.uMax - room && v > patch.vMin + room &&
         v < patch.vMax - room && patch.indexOf(u, v) >= 0;
}

Slices cut(const DepthPatch& patch, const CylinderFrame& frame, const ViewedCylinder& cylinder,
           const Vector3d& tool) {
  const CylinderOutline outline(cylinder);
  const NearLine line = NearLine::fromCylinder(cylinder);
  const Vector3d direction = line.direction();
  Slices cutting;
  cutting.width = std::max(2.0 * patch.pitch, patch.cell / 3.0);
  const double reach = 1.5 * patch.side * patch.cell;
  cutting.begin = -reach;
  cutting.slices.resize(static_cast<std::size_t>(2.0 * reach / cutting.width) + 1);
  for (std::size_t i = 0; i < cutting.slices.size(); ++i) {
    Slice& slice = cutting.slices[i];
    const double u = cutting.middle(i);
    slice.u = u;
    slice.q = line.q(u);
    if (!(slice.q > 0.0)) continue;
    const Vector3d p = line.at(u);
    slice.along = direction.dot(p - tool);
    slice.inPicture = inPicture(patch, frame, p);
    const double half = (outline.edge(u, true) - outline.edge(u, false)) / 2.0;
    slice.expected = 2.0 * tuning.inner * half * cutting.width / (patch.pitch * patch.pitch);
  }
  for (const int cell : cellsBeside(patch, frame, line, tuning.inner * cylinder.radius())) {
    const auto k = static_cast<std::size_t>(cell);
    for (std::size_t i = patch.begin[k]; i < patch.begin[k + 1]; ++i) {
      addTo(cutting, frame.look(patch.samples[i]), patch.noise, cylinder, outline);
    }
  }
  return cutting;
}

struct Followed {
  double u = 0.0, farthest = 0.0;
  bool seen = false;
  int on = 0, off = 0;  ///< slices up to the end: seen as cylinder, and seen to be none
};

/// Walks outwards from slice `from` in steps of `step`.
class Walk {
 public:
  Walk(const Slices& cutting, const DepthPatch& patch, const AlongRange& range)
      : m_cutting(cutting), m_patch(patch), m_range(range) {}

  Followed follow(std::ptrdiff_t from, int step) const {
    const auto count = static_cast<std::ptrdiff_t>(m_cutting.slices.size());
    const int shortest = slicesOf(tuning.endCells * m_patch.cell) + 1,
              longest = slicesOf(tuning.emptyCells * m_patch.cell);
    Followed end;
    end.u = end.farthest = m_cutting.middle(static_cast<std::size_t>(from));
    int ended = 0, empty = 0, covered = 0, off = 0;
    for (std::ptrdiff_t i = from; i >= 0 && i < count; i += step) {
      const Slice& slice = m_cutting.slices[static_cast<std::size_t>(i)];
      if (slice.q <= 0.0) break;
      if (slice.along < m_range.from || slice.along > m_range.to) break;
      if (!m_range.holds(slice.along)) continue;
      const double outer =
          m_cutting.middle(static_cast<std::size_t>(i)) + step * m_cutting.width / 2.0;
      const SliceKind kind = kindOf(slice, m_patch.noise);
      if (kind == SliceKind::On) {
        end.u = end.farthest = outer;
        end.off = off;
        ++end.on;
        ended = empty = covered = 0;
        continue;
      }
      if (kind == SliceKind::Empty && !slice.inPicture && end.on > 0 && ended >= tuning.atBorder &&
          covered == 0) {
        end.seen = true;  // just before the border
        return end;
      }
      if (kind == SliceKind::Covered || (kind == SliceKind::Empty && !slice.inPicture)) {
        ++covered;
        end.farthest = outer;
      } else {
        ++(kind == SliceKind::Ended ? ended : empty);
      }
      off += kind == SliceKind::Ended ? 1 : 0;
      const int enough = end.on > 0 ? shortest : tuning.beforeFirst * shortest;
      if (ended >= enough || ended + empty >= longest) {
        // Before a sky that gives no depth an end is seen as well.
        end.seen = covered < shortest;
        return end;
      }
    }
    return end;
  }

 private:
  int slicesOf(double width) const { return static_cast<int>(std::ceil(width / m_cutting.width)); }
  const Slices& m_cutting;
  const DepthPatch& m_patch;
  const AlongRange& m_range;
};

/// Where the camera sees a slice's middle on the flat end at `along`: how much less its inverse
/// depth is than that of the round surface.
double offOnFlat(const Slice& slice, const Vector3d& ray, const Vector3d& outwards, double end) {
  const double depth = end / ray.dot(outwards);  // the plane of the end: p . outwards = end
  return depth > 0.0 ? std::min(0.0, 1.0 / depth - slice.q) : 0.0;
}

/// Where the flat end faces the camera it is seen beyond the round surface, and leaves it
/// gradually: the place for which what is seen on both fits best. `u` is where it was left for
/// certain.
double sharpened(const Slices& cutting, const NearLine& line, double u, int step, double noise) {
  const Vector3d outwards = line.direction() * step, edge = line.at(u);
  if (outwards.dot(edge.normalized()) > tuning.facing) return u;
  const double end = outwards.dot(edge);
  double best = u, least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < tuning.flatSteps; ++k) {
    const double back = tuning.flatRange * k / tuning.flatSteps;
    double cost = 0.0;
    for (const Slice& slice : cutting.slices) {
      const double beyond = outwards.dot(line.at(slice.u)) - end;
      if (slice.on == 0 || slice.q <= 0.0 || std::abs(beyond) > tuning.flatRange) continue;
      const Vector3d ray(1.0, slice.u, line.v(slice.u));
      const double off = beyond > -back ? offOnFlat(slice, ray, outwards, end - back) : 0.0;
      const double sigmas = (slice.sum / slice.on - off) * std::sqrt(double(slice.on)) / noise;
      cost += std::min(sigmas * sigmas, tuning.flatOutlier);
    }
    if (cost < least) {
      least = cost;
      const Vector3d p = edge - outwards * back;
      best = p[1] / p[0];
    }
  }
  return best;
}

}  // namespace

double CylinderEnds::alongAxis(const ViewedCylinder& cylinder, double u) {
  const Vector3d axis = cylinder.direction(), a = cylinder.pointA();
  const Vector3d away = a - axis * axis.dot(a);
  const Vector3d nearLine = a - away.normalized() * cylinder.radius();
  return (u * nearLine[0] - nearLine[1]) / (axis[1] - u * axis[0]);
}

CylinderEnds findEnds(const DepthPatch& patch, const CylinderFrame& frame,
                      const ViewedCylinder& cylinder, const Vector3d& tool,
                      const AlongRange& range) {
  const Slices cutting = cut(patch, frame, cylinder, tool);
  CylinderEnds ends;
  std::size_t from = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cutting.slices.size(); ++i) {
    const Slice& slice = cutting.slices[i];
    if (slice.q > 0.0 && std::abs(slice.along) < least) from = i, least = std::abs(slice.along);
  }
  if (!std::isfinite(least)) return ends;
  const Walk walk(cutting, patch, range);
  const NearLine line = NearLine::fromCylinder(cylinder);
  int on = 0, off = 0;
  for (const std::size_t side : {0U, 1U}) {
    const Followed end = walk.follow(static_cast<std::ptrdiff_t>(from), side == 0 ? -1 : 1);
    ends.u[side] =
        end.seen ? sharpened(cutting, line, end.u, side == 0 ? -1 : 1, patch.noise) : end.u;
    ends.farthest[side] = end.farthest;
    ends.seen[side] = end.seen;
    ends.shown[side] = end.on * cutting.width;
    on += end.on;
    off += end.off;
  }
  ends.filled = on > 0 ? static_cast<double>(on) / (on + off) : 0.0;
  return ends;
}

}  // namespace boomwatch
