#pragma once

#include <QImage>

#include "tracking/tool_model.h"

namespace boomwatch {

/// What a model of the tool knows, as a picture of two rows: the newest views of the tool, and
/// below them the newest of other things. A view is patchSide x patchSide pixels; at most
/// patchesInRow in a row. Null when it knows nothing. Any thread.
QImage patchStrip(const ToolModel& model);

inline constexpr int patchSide = 28;
inline constexpr int patchesInRow = 10;

}  // namespace boomwatch
