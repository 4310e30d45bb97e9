#include "rate_meter.h"

namespace boomwatch {

void RateMeter::note(TimePoint now) {
  constexpr std::size_t fewest = 3;
  m_times.push_back(now);
  while (m_times.size() > fewest && now - m_times.front() > std::chrono::seconds(1)) {
    m_times.pop_front();
  }
}

double RateMeter::perSecond() const {
  if (m_times.size() < 2) return 0.0;
  const std::chrono::duration<double> span = m_times.back() - m_times.front();
  return span.count() > 0.0 ? static_cast<double>(m_times.size() - 1) / span.count() : 0.0;
}

}  // namespace boomwatch
