#pragma once

#include "command_line.h"
#include "pipeline/result.h"

namespace boomwatch {

/// What a run without a window came to.
struct HeadlessOutcome {
  int exitCode = 0;  ///< 0 done, 1 a fault in the run
  ResultPtr last;    ///< with a copy of the model; absent if no frame came
};

/// Runs the pipeline over the source, every frame in order, and writes one JSON line a frame.
/// Faults of single frames go to standard error and the run goes on. Throws Error when the source
/// cannot be opened or the output cannot be written.
HeadlessOutcome runHeadless(const CommandLine& line);

}  // namespace boomwatch
