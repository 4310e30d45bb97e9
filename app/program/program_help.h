#pragma once

#include <string>

#include "program/program.h"

namespace boomwatch {

/// The text of --help: usage, commands and options of the nameless command, sections.
std::string helpText(const Program& program);

/// The text of COMMAND --help, of a command of this program.
std::string helpText(const Program& program, const ProgramCommand& command);

/// "boomwatch-lab evaluate FOLDER... [OPTIONS]".
std::string usageText(const Program& program, const ProgramCommand& command);

/// "--frames N".
std::string optionText(const ProgramOption& option);

}  // namespace boomwatch
