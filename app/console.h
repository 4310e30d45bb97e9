#pragma once

#include "command_line.h"
#include "pipeline/result.h"

class QApplication;

namespace boomwatch {

/// Runs the window until it is closed, or until its screenshot is saved. The exit code: 0 done, 1 a
/// fault in the run. Faults go to standard error as well as into the window.
int runConsole(QApplication& application, const CommandLine& line);

/// The whole window as it would show `result`, as PNG. Needs a QApplication. False if the file
/// cannot be written.
bool saveWindowScreenshot(const ResultPtr& result, const QString& file);

}  // namespace boomwatch
