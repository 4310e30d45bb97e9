#include "load/cylinder_strip.h"

#include <algorithm>
#include <cmath>

namespace boomwatch {
namespace {

using Eigen::Vector3d;
using Seen = CylinderFrame::Seen;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// One cut across the strip, about its middle.
struct Slice {
  double u = 0.0, low = 0.0, high = 0.0;
  double q = 0.0;  ///< median of the inner half
  bool lowIsEdge = true, highIsEdge = true;
};

/// y = a + b x, robustly: what is far from the line of the others pulls less and less.
struct FittedLine {
  double a = 0.0, b = 0.0;
  double at(double x) const { return a + b * x; }
  FittedLine(const std::vector<Slice>& slices, double (*y)(const Slice&), double scale) {
    std::vector<double> weights(slices.size(), 1.0);
    for (int k = 0; k < 8; ++k) {
      double w = 0, x = 0, xx = 0, f = 0, xf = 0;
      for (std::size_t i = 0; i < slices.size(); ++i) {
        const double weight = weights[i], u = slices[i].u, value = y(slices[i]);
        w += weight, x += weight * u, xx += weight * u * u;
        f += weight * value, xf += weight * u * value;
      }
      const double determinant = w * xx - x * x;
      b = determinant > 1e-12 * w * w ? (w * xf - x * f) / determinant : 0.0;
      a = (f - b * x) / w;
      for (std::size_t i = 0; i < slices.size(); ++i) {
        const double off = (y(slices[i]) - at(slices[i].u)) / scale;
        weights[i] = 1.0 / (1.0 + off * off);
      }
    }
  }
};

class Cutter {
 public:
  Cutter(const DepthPatch& patch, const CylinderFrame& frame, const LoadAxis& axis,
         const LoadBody& body, const Strip::Limits& limits)
      : m_patch(patch),
        m_frame(frame),
        m_limits(limits),
        m_width(std::max(patch.cell / 2.0, 1.5 * patch.pitch)) {
    const Vector3d step = 0.1 * axis.direction;
    const Seen a = frame.look(Vector3d(axis.point - step)),
               b = frame.look(Vector3d(axis.point + step));
    m_line.ua = a.u, m_line.ub = b.u;
    m_line.x << a.v, b.v, a.q, b.q, limits.halfWidth;
    m_axis = axis;
    m_tool = body.tool;
  }

  std::vector<Seen> take(const std::vector<int>& cells) const {
    std::vector<Seen> taken;
    for (const int cell : cells) {
      const auto i = static_cast<std::size_t>(cell);
      for (std::size_t k = m_patch.begin[i]; k < m_patch.begin[i + 1]; ++k) {
        const Seen seen = m_frame.look(m_patch.samples[k]);
        if (isNear(seen)) taken.push_back(seen);
      }
    }
    std::sort(taken.begin(), taken.end(), [](const Seen& p, const Seen& q) { return p.u < q.u; });
    return taken;
  }

  /// Of samples in the order of u.
  std::vector<Slice> cut(const std::vector<Seen>& taken,
                         std::vector<Strip::Surface>& surface) const {
    std::vector<Slice> slices;
    std::vector<Seen> column;
    for (std::size_t i = 0; i < taken.size();) {
      const double end = taken[i].u + m_width;
      column.clear();
      for (; i < taken.size() && taken[i].u < end; ++i) column.push_back(taken[i]);
      if (const auto slice = sliceOf(column, end - m_width / 2.0, surface))
        slices.push_back(*slice);
    }
    return slices;
  }

 private:
  bool isNear(const Seen& s) const {
    const double q = m_line.axisQ(s.u), v = m_line.axisV(s.u);
    if (q <= 0.0 || std::abs(s.v - v) > m_limits.halfWidth * q) return false;
    const double gate = 3.5 * m_patch.noise + (m_limits.halfWidth + 0.05) * q * q;
    if (std::abs(s.q - q) > gate) return false;
    const Vector3d p = m_frame.toCamera(Vector3d(1.0, s.u, v) / q);
    return (p - m_tool).norm() > m_limits.toolRadius &&
           std::abs(m_axis.direction.dot(p - m_axis.point)) <= m_limits.halfLength;
  }

  /// Outwards from the sample nearest to the axis, until there is a gap.
  std::optional<Slice> sliceOf(std::vector<Seen>& column, double u,
                               std::vector<Strip::Surface>& surface) const {
    if (column.size() < 3) return std::nullopt;
    std::sort(column.begin(), column.end(), [](const Seen& p, const Seen& q) { return p.v < q.v; });
    const double widest = 3.5 * m_patch.pitch, axis = m_line.axisV(u);
    const auto nearer = [axis](const Seen& p, const Seen& q) {
      return std::abs(p.v - axis) < std::abs(q.v - axis);
    };
    const auto middle = std::min_element(column.begin(), column.end(), nearer);
    auto low = middle, high = middle;
    while (low != column.begin() && low->v - (low - 1)->v < widest) --low;
    while (high + 1 != column.end() && (high + 1)->v - high->v < widest) ++high;
    if (high - low < 2) return std::nullopt;
    const double q = m_line.axisQ(u), room = m_limits.halfWidth * q - widest;
    Slice slice{u,   low->v - m_patch.pitch / 2.0, high->v + m_patch.pitch / 2.0,
                0.0, axis - low->v < room,         high->v - axis < room};
    std::vector<double> inner;
    const double centre = (slice.low + slice.high) / 2.0, half = (slice.high - slice.low) / 2.0;
    for (auto s = low; s <= high; ++s) {
      if (std::abs(s->v - centre) <= half / 2.0) inner.push_back(s->q);
    }
    addMeans(low, high + 1, surface);
    slice.q = median(inner.empty() ? std::vector<double>{middle->q} : inner);
    return slice;
  }

  /// Of a few equal parts of a slice: as good as all its samples, and far fewer.
  template <class Iterator>
  static void addMeans(Iterator low, Iterator end, std::vector<Strip::Surface>& surface) {
    constexpr double parts = 5.0;
    const double width = std::max(1e-9, (std::prev(end)->v - low->v) / parts);
    while (low != end) {
      const double limit = low->v + width;
      Strip::Surface mean{0.0, 0.0, 0.0, 0};
      for (; low != end && (low->v < limit || mean.count == 0); ++low) {
        mean.u += low->u, mean.v += low->v, mean.q += low->q;
        ++mean.count;
      }
      mean.u /= mean.count, mean.v /= mean.count, mean.q /= mean.count;
      surface.push_back(mean);
    }
  }

  const DepthPatch& m_patch;
  const CylinderFrame& m_frame;
  Strip::Limits m_limits;
  double m_width;
  ViewedCylinder m_line;  ///< its axis alone is used
  LoadAxis m_axis;
  Vector3d m_tool;
};

/// The cells and those around them: at an outline a cell's median is the background's.
std::vector<int> widened(const std::vector<int>& cells, int side) {
  std::vector<char> in(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
  for (const int cell : cells) {
    const int column = cell % side, row = cell / side;
    for (int y = std::max(0, row - 1); y <= std::min(side - 1, row + 1); ++y) {
      for (int x = std::max(0, column - 1); x <= std::min(side - 1, column + 1); ++x) {
        in[static_cast<std::size_t>(y * side + x)] = 1;
      }
    }
  }
  std::vector<int> result;
  for (std::size_t i = 0; i < in.size(); ++i) {
    if (in[i] != 0) result.push_back(static_cast<int>(i));
  }
  return result;
}

ViewedCylinder guessFrom(const std::vector<Slice>& slices, const DepthPatch& patch) {
  const FittedLine middle(
      slices, [](const Slice& s) { return (s.low + s.high) / 2.0; }, 2.0 * patch.pitch);
  const FittedLine depth(
      slices, [](const Slice& s) { return s.q; }, 2.0 * patch.noise);
  std::vector<double> widths;
  for (const Slice& s : slices) widths.push_back((s.high - s.low) / 2.0 / s.q);
  ViewedCylinder guess;
  guess.ua = slices.front().u, guess.ub = slices.back().u;
  const double radius = median(widths);
  const auto behind = [radius](double q) { return 1.0 / (1.0 / std::max(q, 1e-3) + radius); };
  guess.x << middle.at(guess.ua), middle.at(guess.ub), behind(depth.at(guess.ua)),
      behind(depth.at(guess.ub)), radius;
  return guess;
}

}  // namespace

std::optional<Strip> cutStrip(const DepthPatch& patch, const LoadBody& body,
                              const CylinderFrame& frame, const LoadAxis& axis,
                              const Strip::Limits& limits) {
  constexpr std::size_t leastSurface = 20, leastSlices = 6;
  const Cutter cutter(patch, frame, axis, body, limits);
  Strip strip;
  const auto slices = cutter.cut(cutter.take(widened(body.cells, patch.side)), strip.surface);
  if (slices.size() < leastSlices || strip.surface.size() < leastSurface) return std::nullopt;
  for (const Slice& s : slices) {
    if (s.lowIsEdge) strip.edges.push_back({s.u, s.low, false});
    if (s.highIsEdge) strip.edges.push_back({s.u, s.high, true});
  }
  strip.guess = guessFrom(slices, patch);
  return strip;
}

}  // namespace boomwatch
