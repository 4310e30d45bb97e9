#pragma once

#include "frame/clearance.h"
#include "frame/frame.h"
#include "parameters/parameters.h"
#include "tracking/tool_track.h"

namespace boomwatch {

/// Whether the operator or the source has given the tool's place or appearance. Pure.
bool isToolNamed(const ToolTrack& tool);

/// Who gives the load of this frame. `wanted` is the setting; its `Auto` becomes one of the others.
/// Pure.
LoadSource loadSource(LoadSource wanted, const Frame& frame, const ToolTrack& tool);

/// Why there is no distance of the load; `None` when it can be computed. `source` is what
/// loadSource() gave, `load` in the camera frame, metres. Pure.
Reason loadReason(const std::optional<OrientedBox>& load, LoadSource source, const ToolTrack& tool,
                  const Bounds& bounds);

}  // namespace boomwatch
