#pragma once

#include <QString>

#include "parameters/parameters.h"
#include "tracking/tool_track.h"

namespace boomwatch {

/// Translated texts for the state of the tracker. GUI thread.

/// The choice as the parameter spells it, and what the tracker can do.
QString trackerText(TrackerKind kind);
/// A few words beside the tool's box: "Tool 83 %", "Tool re-detected 83 %". Empty without a box.
QString toolLabel(const ToolTrack& tool);
/// A sentence: the state of the tracker, and what it means for the distance.
QString toolSentence(const ToolTrack& tool, const TrackingParameters& parameters);
/// Whether the tracker learns; gives the reason when learning is suspended.
QString learningSentence(LearningState state);
/// The size of a model: "12 views of the tool, 40 of the background".
QString modelText(const ToolModel& model);

}  // namespace boomwatch
