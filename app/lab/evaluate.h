#pragma once

#include "lab/lab_command_line.h"

namespace boomwatch {

/// Runs trackers over sequences with ground truth (see lab/evaluation/tracker_run.h): a table
/// on standard output, progress on standard error, and in order.output the folder's tracking.csv
/// and tracking.md, written whole or not at all. A sequence that cannot be read is named and the
/// others run. Interrupted by Ctrl-C, it ends with what is complete, and says what is not. Returns
/// 0 when everything is complete, 1 otherwise. Throws Error when the paths, the trackers' names or
/// the folder are wrong.
int runEvaluation(const EvaluationOrder& order);

}  // namespace boomwatch
