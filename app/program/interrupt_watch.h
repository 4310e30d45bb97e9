#pragma once

namespace boomwatch {

/// Ctrl-C (and a request to end) while one of these lives is noted, and ends nothing by itself.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// Whether one came since the watch began. Any thread.
  static bool interrupted();

 private:
  void (*m_interrupt)(int);  ///< the handlers that were there before
  void (*m_terminate)(int);
};

}  // namespace boomwatch
