#pragma once

#include <QString>
#include <string_view>

#include "environment/environment_model.h"
#include "frame/clearance.h"
#include "load/load_detection.h"
#include "pipeline/warning_level.h"
#include "pipeline/watched.h"

namespace boomwatch {

/// Translated texts for the values that core computes. GUI thread.

/// Two or three words: "No frames". Empty for Reason::None.
QString reasonTitle(Reason reason);
/// A sentence or two: what is wrong and what to do. Empty for Reason::None.
QString reasonText(Reason reason);
/// A sentence. Empty for LoadFault::None.
QString loadFaultText(LoadFault fault);
QString levelText(WarningLevel level);
/// The name of a StageTiming; an unknown name stays as it is.
QString stageText(std::string_view stage);
QString partText(LoadPart part);
QString cellText(CellState state);
/// "boom 2".
QString watchedText(const Watched& watched);
/// "boom 2: 1.20 m", or why there is no distance.
QString watchedDistance(const Watched& watched);

/// "3.70 m": in the user's locale, with a fixed number of digits.
QString metresText(double metres);

}  // namespace boomwatch
