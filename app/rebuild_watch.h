#pragma once

#include <chrono>
#include <optional>

#include "environment/grid_geometry.h"
#include "pipeline/result.h"

namespace boomwatch {

/// Knows whether the model that is shown is still the one before a change of its size.
class RebuildWatch {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// Parameters have been sent.
  void want(const Parameters& parameters);
  /// A result is shown.
  void show(const Result& result, TimePoint now);
  /// From the change of size until the new model is shown, and long enough to be read.
  bool rebuilding(TimePoint now) const;

 private:
  std::optional<GridGeometry> m_wanted;
  std::optional<GridGeometry> m_shown;
  std::optional<TimePoint> m_rebuilt;
};

}  // namespace boomwatch
