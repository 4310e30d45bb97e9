#pragma once

#include "simulation/demo_export.h"

namespace boomwatch {

/// Exports a demo with its progress on standard error; Ctrl-C stops it, and nothing is left behind.
/// Returns the exit code. Throws as exportDemo does.
int runExport(const DemoExport& what);

}  // namespace boomwatch
