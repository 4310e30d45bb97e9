#pragma once

#include <QByteArray>

#include "pipeline/result.h"

namespace boomwatch {

/// One JSON object on one line, without the line end: frame, stamp, state, reason, distance_m,
/// nearest, on_load, part, uncertainty_m, depth_uncertainty_m, level, observed_share, fill,
/// truth_m, row_residue_px, rows_corrected_px, message, timings_ms. What is not known is null.
QByteArray toJsonLine(const Result& result);

}  // namespace boomwatch
