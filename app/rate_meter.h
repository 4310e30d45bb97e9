#pragma once

#include <chrono>
#include <deque>

namespace boomwatch {

/// Events a second, over the last second or the last few events, whichever is longer.
class RateMeter {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  void note(TimePoint now);
  void reset() { m_times.clear(); }
  /// 0 before the second event.
  double perSecond() const;

 private:
  std::deque<TimePoint> m_times;
};

}  // namespace boomwatch
