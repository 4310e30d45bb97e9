#pragma once

#include <string_view>

#include "frame/clearance.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// In order of urgency, but for NoDistance, which stands beside them.
enum class WarningLevel { Clear, Caution, Warning, Collision, NoDistance };
/// Stable name for files and logs.
std::string_view toString(WarningLevel level);

/// Unknown is NoDistance, never Clear. A distance of 0 is Collision.
WarningLevel warningLevel(const Clearance& clearance, const WarningParameters& parameters);

/// Keeps the worst level since it was last taken, so that a result that nobody had time to show
/// cannot swallow a warning. Worst: Collision, Warning, Caution, NoDistance, Clear.
class WarningLatch {
 public:
  void note(WarningLevel level);
  /// The worst level noted since the last call.
  WarningLevel take();

 private:
  WarningLevel m_worst = WarningLevel::Clear;
};

}  // namespace boomwatch
