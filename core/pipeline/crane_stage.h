#pragma once

#include "crane/crane_memory.h"
#include "crane/static_scene.h"
#include "pipeline/load_stage.h"

namespace boomwatch {

/// Masks boom, tool and load in the cloud. Owns the memory of where the crane was a moment ago.
/// Used by one thread.
class CraneStage {
 public:
  /// `segments` are those of `sensed.cloud` with the same `parameters`; camera frame, metres.
  StaticScene separate(SegmentedCloud segments, const Frame& frame, const SensedFrame& sensed,
                       const ToolTrack& tool, const CarriedLoad& load,
                       const Parameters& parameters);

 private:
  CraneMemory m_memory;
};

}  // namespace boomwatch
