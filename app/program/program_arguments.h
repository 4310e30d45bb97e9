#pragma once

#include <QCommandLineParser>
#include <QStringList>
#include <optional>

#include "parameters/parameters.h"
#include "program/program.h"

namespace boomwatch {

// What both programs read from their command lines in the same way. All throw Error that names the
// option.

/// False when there is an option that `command` has not, or one without its value. `arguments`
/// begins with a program's name.
bool parseArguments(QCommandLineParser& parser, const ProgramCommand& command,
                    const QStringList& arguments);

/// After parseArguments said no: names the option.
[[noreturn]] void failOnArguments(const QCommandLineParser& parser);

/// A whole number from `minimum` on; `option` with its dashes.
int wholeNumber(const QString& option, const QString& value, int minimum);

/// The same of an option without its dashes; absent when it is not given.
std::optional<std::size_t> countOf(const QCommandLineParser& parser, const char* option);

/// --parameters and --set.
std::vector<ProgramOption> parameterOptions();
/// The preset of --parameters.
void readPreset(Parameters& parameters, const QCommandLineParser& parser);
/// All of --set, in their order.
void readSettings(Parameters& parameters, const QCommandLineParser& parser);

/// --frames, --help, --version and --print, which offers `documents`.
ProgramOption framesOption();
ProgramOption helpOption();
std::vector<ProgramOption> ownOptions(std::vector<std::string> documents, const std::string& text);

/// Every parameter with its range and default.
ProgramSection parameterSection();
ProgramSection yardSection();
ProgramSection exitSection();

}  // namespace boomwatch
