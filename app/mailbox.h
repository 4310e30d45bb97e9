#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace boomwatch {

/// One slot between two threads. A writer changes what is waiting; what the latest change leaves is
/// what the reader takes. T decides, by how it is changed, what is replaced and what is gathered.
template <class T>
class Mailbox {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// True when nothing was waiting before: the reader has to be told.
  template <class Change>
  bool post(Change&& change) {
    bool first = false;
    {
      const std::lock_guard lock(m_mutex);
      change(m_waiting);
      first = !std::exchange(m_full, true);
    }
    m_posted.notify_one();
    return first;
  }

  /// What is waiting, or a fresh T.
  T take() {
    const std::lock_guard lock(m_mutex);
    m_full = false;
    return std::exchange(m_waiting, T{});
  }

  /// Returns when something waits, at the latest at `until`; without it, waits for ever.
  void wait(std::optional<TimePoint> until) {
    std::unique_lock lock(m_mutex);
    if (until && *until <= std::chrono::steady_clock::now()) return;
    if (until) {
      m_posted.wait_until(lock, *until, [this] { return m_full; });
    } else {
      m_posted.wait(lock, [this] { return m_full; });
    }
  }

 private:
  std::mutex m_mutex;
  std::condition_variable m_posted;
  T m_waiting{};
  bool m_full = false;
};

}  // namespace boomwatch
