#pragma once

#include "frame/clearance.h"
#include "parameters/parameters.h"
#include "pipeline/result.h"

namespace boomwatch {

/// Whether anybody has said where the tool is, or what it looks like. Of a result whose tool is
/// set.
bool isToolNamed(const Result& result);

/// Who says where the load of this frame is; `Auto` has become one of the others. Of a result whose
/// frame, parameters and tool are set.
LoadSource loadSource(const Result& result);

/// Why there is no distance of the load; `None` when it can be computed. Of a result whose load is
/// set as well.
Reason loadReason(const Result& result);

}  // namespace boomwatch
