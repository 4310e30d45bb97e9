#pragma once

#include "collision/approach.h"
#include "frame/frame.h"
#include "pipeline/warning_memory.h"
#include "pipeline/watched_environment.h"

namespace boomwatch {

/// The chain behind a perfect mask: what is crane, tool and load is taken out of the cloud by what
/// demo:yard knows of every pixel. What errors it has are neither the mask's nor the detector's.
class MaskedChain {
 public:
  struct Outcome {
    Clearance clearance;
    WarningLevel level = WarningLevel::NoDistance;
  };

  /// A frame of demo:yard with a cloud, organised as its picture, and its load.
  Outcome process(const Frame& frame, const Parameters& parameters);

 private:
  std::optional<Approach> approach(const Frame& frame, const Clearance& clearance,
                                   const WarningParameters& limits);

  WatchedEnvironment m_environment;
  LoadMotion m_motion;
  WarningMemory m_warning;
};

}  // namespace boomwatch
