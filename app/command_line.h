#pragma once

#include <QString>
#include <QStringList>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "parameters/parameters.h"
#include "program/program.h"
#include "sources/frame_source.h"

namespace boomwatch {

/// What a person asked for on the command line.
struct CommandLine {
  bool headless = false;
  QString source;  ///< empty: the last one (window) or the built-in demo (headless)
  SourceOptions sourceOptions;
  std::optional<std::size_t> frames;  ///< stop after this many
  QString output;                     ///< JSON lines; empty or "-": standard output
  QString screenshot;                 ///< PNG of the whole window after the last frame
  Parameters parameters;
  std::optional<cv::Point> tool;
  std::optional<cv::Rect> track;           ///< the tool's box in the first picture
  std::vector<std::string> trackerModels;  ///< files; several are merged
  std::string saveTrackerModel;            ///< empty: nowhere
  bool help = false;
  bool version = false;
  QString print;  ///< the document to print, see --print; empty: none
};

/// Throws Error that names the argument. `arguments` begins with the program's name. What moved to
/// boomwatch-lab is named with its new place.
CommandLine parseCommandLine(const QStringList& arguments);

/// What boomwatch says about itself.
Program boomwatchProgram();

}  // namespace boomwatch
