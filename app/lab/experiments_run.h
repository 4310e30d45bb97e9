#pragma once

#include <string>

#include "lab/lab_command_line.h"

namespace boomwatch {

/// Runs the experiments (see lab/experiments/experiment.h) with their progress on standard error,
/// and writes report.md, PNG figures and CSV tables into order.output, a folder that appears when
/// all is complete. Ctrl-C stops them, and nothing is left behind. Needs a QGuiApplication, for
/// fonts. Returns 0 when all is complete, 1 when it was stopped. Throws Error when paths or the
/// folder cannot be used, and std::runtime_error when an experiment or writing fails.
int runExperiments(const ExperimentsOrder& order, const std::string& version);

}  // namespace boomwatch
