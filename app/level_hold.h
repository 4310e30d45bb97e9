#pragma once

#include <chrono>
#include <optional>

#include "pipeline/warning_level.h"

namespace boomwatch {

/// Keeps a warning that passed between two displays in sight long enough to be seen.
class LevelHold {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// `shown` is the level of the display that is shown now, `worst` the worst since the one before.
  void note(WarningLevel shown, WarningLevel worst, TimePoint now);
  /// The level to show in place of the display's own, if any.
  std::optional<WarningLevel> held(TimePoint now) const;

 private:
  std::optional<WarningLevel> m_level;
  TimePoint m_until;
};

}  // namespace boomwatch
