#pragma once

#include <memory>

#include "parameters/parameters.h"
#include "tracking/tracker.h"

namespace boomwatch {

/// Null for TrackerKind::Manual: the operator's click stays where it is.
std::unique_ptr<Tracker> makeTracker(TrackerKind kind);

}  // namespace boomwatch
