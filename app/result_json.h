#pragma once

#include <QByteArray>

#include "pipeline/result.h"

namespace boomwatch {

/// One JSON object on one line, without the line end: frame, stamp, state, reason, distance_m,
/// nearest, on_load, part, uncertainty_m, depth_uncertainty_m, level, observed_share, fill,
/// velocity_m_s, closing_m_s, time_to_contact_s, truth_m, row_residue_px, rows_corrected_px, tool,
/// message, timings_ms. What is not known is null. `tool` is null without a frame, and else an
/// object: state, box (x, y, width, height), confidence, pixel, point, velocity, age_s, learning.
QByteArray toJsonLine(const Result& result);

}  // namespace boomwatch
