#pragma once

#include <deque>
#include <optional>

#include "pipeline/result.h"

namespace boomwatch {

/// The last minute of results, on the source's clock: what the distance plot shows. A frame from an
/// earlier time, or from much later, begins it anew: the source was wound.
class DistanceHistory {
 public:
  static constexpr double span = 60.0;  ///< seconds that are kept
  static constexpr double jump = 5.0;   ///< seconds forward that no gap between frames explains

  struct Moment {
    double stamp = 0.0;
    std::optional<double> distance;  ///< absent: unknown, or nothing in range
    Reason reason = Reason::None;    ///< why it is unknown
    std::optional<double> truth;
    bool bare = false;  ///< no frame came: the stamp is only by the clock on the wall
  };

  /// `sinceFrame`: seconds since the last frame came, for a result without one.
  void add(const Result& result, double sinceFrame = 0.0);
  void clear() { m_moments.clear(); }

  const std::deque<Moment>& moments() const { return m_moments; }
  /// Of the latest; 0 without any.
  double now() const { return m_moments.empty() ? 0.0 : m_moments.back().stamp; }

 private:
  std::optional<double> lastFrame() const;

  std::deque<Moment> m_moments;
};

}  // namespace boomwatch
