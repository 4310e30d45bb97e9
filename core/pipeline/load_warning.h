#pragma once

#include <optional>

#include "collision/approach.h"
#include "collision/exact_clearance.h"
#include "frame/clearance.h"
#include "frame/oriented_box.h"
#include "parameters/parameters.h"
#include "pipeline/warning_memory.h"

namespace boomwatch {

/// One frame, as far as the warning depends on it. Camera frame, metres.
struct LoadAndClearance {
  double stamp = 0.0;                      ///< seconds on the source's clock
  const std::optional<OrientedBox>& load;  ///< absent where it is not known
  const Clearance& clearance;              ///< of the object that leads
  bool isOfLoad = true;                    ///< that object is the load
};

/// Owns the load's motion and the last warning. Used by one thread.
class LoadWarning {
 public:
  struct Outcome {
    /// How the load moves. Absent without a load or a distance, and until the load was seen for
    /// long enough (see LoadMotion).
    std::optional<Approach> approach;
    WarningLevel level = WarningLevel::NoDistance;  ///< see nextWarning
  };

  /// Once a frame. `environment`: the cells that the clearance was measured to.
  Outcome update(const LoadAndClearance& input, const ExactClearance& environment,
                 const WarningParameters& parameters);

 private:
  LoadMotion m_motion;
  WarningMemory m_memory;
};

}  // namespace boomwatch
