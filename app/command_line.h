#pragma once

#include <QString>
#include <QStringList>
#include <opencv2/core.hpp>
#include <optional>

#include "pipeline/parameters.h"
#include "sources/frame_source.h"

namespace boomwatch {

/// What a person asked for on the command line.
struct CommandLine {
  bool headless = false;
  QString source;  ///< empty: the last one (window) or the built-in demo (headless)
  SourceOptions sourceOptions;
  std::optional<std::size_t> frames;  ///< stop after this many
  /// JSON lines; empty or "-": standard output. With exportDemo, the folder.
  QString output;
  QString exportDemo;  ///< as behind "demo:"; empty: none
  bool exportTruthImages = false;
  QString screenshot;  ///< PNG of the whole window after the last frame
  Parameters parameters;
  bool parametersGiven = false;  ///< any of --parameters, --set, --load
  std::optional<cv::Point> tool;
  bool help = false;
  bool version = false;
};

/// Throws Error that names the argument. `arguments` begins with the program's name.
CommandLine parseCommandLine(const QStringList& arguments);

/// The text of --help, made from the parameter table.
QString helpText();

}  // namespace boomwatch
