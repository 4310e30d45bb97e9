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
  QString output;      ///< JSON lines, empty or "-": standard output; folder for --evaluate
  QString screenshot;  ///< PNG of the whole window after the last frame
  Parameters parameters;
  bool parametersGiven = false;  ///< any of --parameters, --set, --load
  std::optional<cv::Point> tool;
  bool evaluate = false;          ///< run trackers over evaluationFolders; see evaluate.h
  QStringList evaluationFolders;  ///< at least one
  QStringList trackers;           ///< of --tracker; empty: all of them are evaluated
  bool help = false;
  bool version = false;
};

/// Throws Error that names the argument. `arguments` begins with the program's name.
CommandLine parseCommandLine(const QStringList& arguments);

/// The text of --help, made from the parameter table.
QString helpText();

}  // namespace boomwatch
