#include "distance_history.h"

#include <algorithm>

namespace boomwatch {

std::optional<double> DistanceHistory::lastFrame() const {
  const auto last = std::find_if(m_moments.rbegin(), m_moments.rend(),
                                 [](const Moment& moment) { return !moment.bare; });
  return last == m_moments.rend() ? std::nullopt : std::optional(last->stamp);
}

void DistanceHistory::add(const Result& result, double sinceFrame) {
  Moment moment;
  if (result.clearance.nearest) moment.distance = result.clearance.nearest->distance;
  moment.reason = result.clearance.reason;
  const std::optional<double> before = lastFrame();
  if (result.frame) {
    moment.stamp = result.frame->stamp;
    moment.truth = result.frame->trueDistance;
    if (before && (moment.stamp < *before || moment.stamp > *before + jump)) m_moments.clear();
  } else {
    if (!before) return;  // nothing was there before: nothing to show
    moment.bare = true;
    moment.stamp = *before + std::max(0.0, sinceFrame);
  }
  // The same frame again, in other colours; or what the clock on the wall had put ahead of it.
  while (!m_moments.empty() && m_moments.back().stamp >= moment.stamp) m_moments.pop_back();
  m_moments.push_back(moment);
  while (m_moments.front().stamp < now() - span) m_moments.pop_front();
}

}  // namespace boomwatch
