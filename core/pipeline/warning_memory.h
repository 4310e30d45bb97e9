#pragma once

#include <optional>

#include "collision/approach.h"
#include "frame/clearance.h"
#include "pipeline/warning_level.h"

namespace boomwatch {

/// What the warning depends on, of one frame.
struct WarningInput {
  double stamp = 0.0;  ///< seconds on the source's clock
  const Clearance& clearance;
  std::optional<Approach> approach;  ///< absent: it is not known how the load moves
};

/// What the warning remembers from frame to frame.
struct WarningMemory {
  WarningLevel level = WarningLevel::NoDistance;
  std::optional<double> lowerSince;  ///< stamp from which a lower level would have done
};

/// The level of the next frame. Pure.
///
/// - Up at once: a level begins at its distance or, for a load that moves, at its time to contact.
/// - Down late: past the threshold by the deadband, and for as long as the release delay says;
///   a load that retreats is released without the delay.
/// - Unknown is NoDistance at once, and forgets what was before: never the last level, never Clear.
WarningMemory nextWarning(const WarningMemory& memory, const WarningInput& input,
                          const WarningParameters& parameters);

}  // namespace boomwatch
