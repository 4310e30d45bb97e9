#include "load/log/cylinder_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "base/median.h"
#include "load/log/log_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;
using Seen = CylinderFrame::Seen;

constexpr LogTuning::Strip tuning;

/// One cut across the strip.
struct Slice {
  double u = 0.0;
  double q = 0.0;                  ///< median of the inner half
  std::array<double, 2> v{};       ///< where it ends: lower, upper
  std::array<bool, 2> free{};      ///< and something farther away is beyond, or nothing
  std::size_t begin = 0, end = 0;  ///< its samples
};

/// y = a + b x
struct Line {
  double a = 0.0, b = 0.0;
  double at(double x) const { return a + b * x; }
  static Line through(double x1, double y1, double x2, double y2) {
    const double b = (y2 - y1) / (x2 - x1);
    return {y1 - b * x1, b};
  }
};

/// Robustly: what is far from the line of the others pulls less and less.
Line fittedLine(const std::vector<const Slice*>& slices, double (*y)(const Slice&), double scale) {
  Line line;
  std::vector<double> weights(slices.size(), 1.0);
  for (int k = 0; k < tuning.rounds; ++k) {
    double w = 0, x = 0, xx = 0, f = 0, xf = 0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
      const double weight = weights[i], u = slices[i]->u, value = y(*slices[i]);
      w += weight, x += weight * u, xx += weight * u * u;
      f += weight * value, xf += weight * u * value;
    }
    const double determinant = w * xx - x * x;
    line.b = determinant > 1e-12 * w * w ? (w * xf - x * f) / determinant : 0.0;
    line.a = (f - line.b * x) / w;
    for (std::size_t i = 0; i < slices.size(); ++i) {
      const double off = (y(*slices[i]) - line.at(slices[i]->u)) / scale;
      weights[i] = 1.0 / (1.0 + off * off);
    }
  }
  return line;
}

class Cutter {
 public:
  Cutter(const DepthPatch& patch, const CylinderFrame& frame, const NearLine& line,
         const Vector3d& tool, const CylinderStrip::Limits& limits)
      : m_patch(patch),
        m_frame(frame),
        m_line(line),
        m_limits(limits),
        m_width(std::max(patch.cell / 2.0, 1.5 * patch.pitch)),
        m_begin(-patch.side * patch.cell) {
    const Vector3d direction = line.direction();
    const auto count = static_cast<std::size_t>(-2.0 * m_begin / m_width) + 1;
    m_open.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double u = middle(i);
      if (!(line.q(u) > 0.0)) continue;
      m_open[i] = limits.along.holds(direction.dot(line.at(u) - tool));
    }
  }

  std::vector<Slice> cut() {
    take();
    std::vector<Slice> slices;
    for (std::size_t i = 0; i + 1 < m_first.size(); ++i) {
      if (const auto slice = sliceOf(m_first[i], m_first[i + 1], middle(i))) {
        slices.push_back(*slice);
      }
    }
    return slices;
  }
  const std::vector<Seen>& samples() const { return m_samples; }

 private:
  double middle(std::size_t i) const { return m_begin + (static_cast<double>(i) + 0.5) * m_width; }

  /// The samples beside the line, sorted into slices.
  void take() {
    std::vector<std::pair<std::size_t, Seen>> found;
    m_first.assign(m_open.size() + 1, 0);
    for (const int cell : cellsBeside(m_patch, m_frame, m_line, m_limits.halfWidth)) {
      const auto c = static_cast<std::size_t>(cell);
      for (std::size_t k = m_patch.begin[c]; k < m_patch.begin[c + 1]; ++k) {
        const Seen seen = m_frame.look(m_patch.samples[k]);
        const double place = (seen.u - m_begin) / m_width;
        if (!(place >= 0.0 && place < static_cast<double>(m_open.size()))) continue;
        const auto slice = static_cast<std::size_t>(place);
        if (m_open[slice] == 0) continue;
        if (std::abs(seen.v - m_line.v(seen.u)) > m_limits.halfWidth * m_line.q(seen.u)) continue;
        found.emplace_back(slice, seen);
        ++m_first[slice + 1];
      }
    }
    for (std::size_t i = 1; i < m_first.size(); ++i) m_first[i] += m_first[i - 1];
    m_samples.resize(found.size());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for (const auto& [slice, seen] : found) m_samples[next[slice]++] = seen;
  }

  /// Outwards from the sample nearest to the line.
  std::optional<Slice> sliceOf(std::size_t begin, std::size_t end, double u) {
    if (end - begin < 3) return std::nullopt;
    const auto first = m_samples.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = m_samples.begin() + static_cast<std::ptrdiff_t>(end);
    std::sort(first, last, [](const Seen& p, const Seen& q) { return p.v < q.v; });
    const double q = m_line.q(u), v = m_line.v(u);
    const double gate = LogTuning::gate * m_patch.noise + tuning.deep * q * q;
    std::ptrdiff_t start = -1;
    for (auto s = first; s != last; ++s) {
      if (std::abs(s->q - q) > gate) continue;
      if (start < 0 || std::abs(s->v - v) < std::abs((first + start)->v - v)) start = s - first;
    }
    const double room = m_limits.halfWidth * q - tuning.gap * m_patch.pitch;
    if (start < 0 || std::abs((first + start)->v - v) > room / 2.0) return std::nullopt;
    Slice slice;
    slice.u = u;
    const auto low = static_cast<std::size_t>(walk(first, end - begin, start, -1, slice));
    const auto high = static_cast<std::size_t>(walk(first, end - begin, start, 1, slice));
    if (high - low < 2) return std::nullopt;
    slice.begin = begin + low, slice.end = begin + high + 1;
    slice.free[0] = slice.free[0] && v - slice.v[0] < room;
    slice.free[1] = slice.free[1] && slice.v[1] - v < room;
    slice.q = innerMedian(slice);
    return slice;
  }

  /// To the last sample of the same surface; those that stray alone are passed over.
  template <class Iterator>
  std::ptrdiff_t walk(Iterator samples, std::size_t size, std::ptrdiff_t start, int step,
                      Slice& slice) const {
    const auto count = static_cast<std::ptrdiff_t>(size);
    const std::size_t side = step < 0 ? 0 : 1;
    std::ptrdiff_t at = start;
    double mean = samples[start].q;
    int off = 0, before = 0;
    for (auto i = start + step; i >= 0 && i < count && off < tuning.strays; i += step) {
      const Seen& s = samples[i];
      if (std::abs(s.v - samples[at].v) > tuning.gap * m_patch.pitch) break;
      const double difference = s.q - mean;
      if (std::abs(difference) > LogTuning::gate * m_patch.noise + tuning.steep * mean * mean) {
        ++off;
        before += difference > 0.0 ? 1 : 0;
        continue;
      }
      at = i, off = before = 0;
      mean += tuning.meanGain * difference;
    }
    slice.v[side] = samples[at].v + step * m_patch.pitch / 2.0;
    slice.free[side] = before == 0;
    return at;
  }

  double innerMedian(const Slice& slice) const {
    const double centre = (slice.v[0] + slice.v[1]) / 2.0, half = (slice.v[1] - slice.v[0]) / 2.0;
    std::vector<double> inner;
    for (std::size_t k = slice.begin; k < slice.end; ++k) {
      if (std::abs(m_samples[k].v - centre) <= half / 2.0) inner.push_back(m_samples[k].q);
    }
    return inner.empty() ? m_samples[(slice.begin + slice.end) / 2].q : medianOf(inner);
  }

  const DepthPatch& m_patch;
  const CylinderFrame& m_frame;
  const NearLine& m_line;
  CylinderStrip::Limits m_limits;
  double m_width, m_begin;
  std::vector<char> m_open;  ///< slices that are looked at
  std::vector<std::size_t> m_first;
  std::vector<Seen> m_samples;
};

/// Two straight lines on which slices end.
struct Outline {
  std::array<Line, 2> sides;
  double within = 0.0;

  bool holds(const Slice& slice, std::size_t side) const {
    return std::abs(slice.v[side] - sides[side].at(slice.u)) < within;
  }
  /// With at least one end on its line, and no free end elsewhere.
  bool fits(const Slice& slice) const {
    const bool low = holds(slice, 0), high = holds(slice, 1);
    return (low && high) || (low && slice.free[0] && !slice.free[1]) ||
           (high && slice.free[1] && !slice.free[0]);
  }
};

/// By drawing two slices at a time; the outline that most slices fit.
std::optional<Outline> outlineOf(const std::vector<Slice>& slices, const DepthPatch& patch,
                                 const CylinderStrip::Limits& limits) {
  std::vector<const Slice*> whole;
  for (const Slice& s : slices) {
    if (s.free[0] && s.free[1]) whole.push_back(&s);
  }
  if (whole.size() < 4) return std::nullopt;
  const double apart = tuning.drawsApart * (whole.back()->u - whole.front()->u);
  std::minstd_rand random(1);
  std::optional<Outline> best;
  int most = 0;
  for (int k = 0; k < tuning.draws; ++k) {
    const Slice& a = *whole[random() % whole.size()];
    const Slice& b = *whole[random() % whole.size()];
    if (!(std::abs(a.u - b.u) > apart)) continue;
    const double widthA = (a.v[1] - a.v[0]) / a.q, widthB = (b.v[1] - b.v[0]) / b.q;
    if (std::abs(widthA - widthB) > tuning.taper * std::min(widthA, widthB)) continue;
    if (!(widthA > tuning.minWidth * limits.minRadius &&
          widthA < tuning.maxWidth * limits.maxRadius))
      continue;
    Outline tried;
    tried.within = tuning.outlinePitches * patch.pitch + tuning.outlineMetres * a.q;
    for (const std::size_t side : {0U, 1U}) {
      tried.sides[side] = Line::through(a.u, a.v[side], b.u, b.v[side]);
    }
    int held = 0;
    for (const Slice& s : slices) held += tried.fits(s) ? 1 : 0;
    if (held > most) most = held, best = tried;
  }
  return best;
}

/// Of a few equal parts of a slice: as good as all its samples, and far fewer.
void addMeans(const std::vector<Seen>& samples, const Slice& slice,
              std::vector<CylinderStrip::Surface>& surface) {
  const double width =
      std::max(1e-9, (samples[slice.end - 1].v - samples[slice.begin].v) / tuning.parts);
  for (std::size_t k = slice.begin; k < slice.end;) {
    const double limit = samples[k].v + width;
    CylinderStrip::Surface mean{0.0, 0.0, 0.0, 0};
    for (; k < slice.end && (samples[k].v < limit || mean.count == 0); ++k) {
      mean.u += samples[k].u, mean.v += samples[k].v, mean.q += samples[k].q;
      ++mean.count;
    }
    mean.u /= mean.count, mean.v /= mean.count, mean.q /= mean.count;
    surface.push_back(mean);
  }
}

ViewedCylinder guessFrom(const std::vector<const Slice*>& slices, const Outline& outline,
                         const DepthPatch& patch) {
  const Line depth = fittedLine(
      slices, [](const Slice& s) { return s.q; }, 2.0 * patch.noise);
  ViewedCylinder guess;
  guess.ua = slices.front()->u, guess.ub = slices.back()->u;
  const auto middle = [&](double u) {
    return (outline.sides[0].at(u) + outline.sides[1].at(u)) / 2.0;
  };
  std::vector<double> widths;
  for (const Slice* s : slices) {
    widths.push_back((outline.sides[1].at(s->u) - outline.sides[0].at(s->u)) / 2.0 /
                     depth.at(s->u));
  }
  const double radius = medianOf(widths);
  const auto behind = [radius](double q) { return 1.0 / (1.0 / std::max(q, 1e-3) + radius); };
  guess.x << middle(guess.ua), middle(guess.ub), behind(depth.at(guess.ua)),
      behind(depth.at(guess.ub)), radius;
  return guess;
}

}  // namespace

std::optional<CylinderStrip> cutStrip(const DepthPatch& patch, const CylinderFrame& frame,
                                      const NearLine& line, const Vector3d& tool,
                                      const CylinderStrip::Limits& limits) {
  Cutter cutter(patch, frame, line, tool, limits);
  const std::vector<Slice> slices = cutter.cut();
  const auto outline = outlineOf(slices, patch, limits);
  if (!outline) return std::nullopt;
  CylinderStrip strip;
  std::vector<const Slice*> kept;
  for (const Slice& s : slices) {
    if (!outline->fits(s)) continue;
    kept.push_back(&s);
    addMeans(cutter.samples(), s, strip.surface);
    for (const std::size_t side : {0U, 1U}) {
      if (s.free[side] && outline->holds(s, side)) {
        strip.edges.push_back({s.u, s.v[side], side == 1});
      }
    }
  }
  if (kept.size() < tuning.minSlices || strip.surface.size() < tuning.minSurface)
    return std::nullopt;
  strip.guess = guessFrom(kept, *outline, patch);
  strip.outlined = static_cast<double>(kept.size()) / static_cast<double>(slices.size());
  return strip;
}

}  // namespace boomwatch
