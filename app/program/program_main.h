#pragma once

#include <QStringList>
#include <functional>
#include <string>

namespace boomwatch {

enum ExitCode { Done = 0, FaultInRun = 1, BadArguments = 2 };

/// What main of both programs does around its work: prepares the process and turns what `work`
/// throws into a message on standard error and an exit code. Error: bad arguments; everything else:
/// a fault in the run.
int runProgram(const char* name, const std::function<int()>& work);

/// "0.2.0".
std::string programVersion();

QStringList argumentsOf(int argc, char** argv);

/// To standard output; returns Done.
int print(const std::string& text);

}  // namespace boomwatch
