#pragma once

#include <QString>

#include "parameters/parameters.h"
#include "tracking/tool_track.h"

namespace boomwatch {

/// Words for what the tracker does; translated. GUI thread.

/// As the parameter spells it, and what it is good for.
QString trackerText(TrackerKind kind);
/// A few words beside the tool's box: "Tool 83 %", "Tool found again 83 %". Empty without a box.
QString toolLabel(const ToolTrack& tool);
/// A sentence: where the tracker stands, and what that means for the distance.
QString toolSentence(const ToolTrack& tool, const TrackingParameters& parameters);
/// What becomes of what the tracker sees; says why when it is suspended.
QString learningSentence(LearningState state);
/// How much a model knows: "views of the tool 12, of other things 40".
QString modelText(const ToolModel& model);

}  // namespace boomwatch
