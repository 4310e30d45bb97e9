#pragma once

#include <QString>
#include <QStringList>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "parameters/parameters.h"
#include "sources/frame_source.h"

namespace boomwatch {

/// What a person asked for on the command line.
struct CommandLine {
  bool headless = false;
  QString source;  ///< empty: the last one (window) or the built-in demo (headless)
  SourceOptions sourceOptions;
  std::optional<std::size_t> frames;  ///< stop after this many
  /// JSON lines; empty or "-": standard output. A folder with exportDemo, evaluate
  /// and experiments.
  QString output;
  QString exportDemo;  ///< as behind "demo:"; empty: none
  bool exportTruthImages = false;
  QString screenshot;  ///< PNG of the whole window after the last frame
  Parameters parameters;
  std::optional<cv::Point> tool;
  std::optional<cv::Rect> track;           ///< the tool's box in the first picture
  std::vector<std::string> trackerModels;  ///< files; several are merged
  std::string saveTrackerModel;            ///< empty: nowhere
  bool evaluate = false;                   ///< run trackers over evaluationFolders; see evaluate.h
  QStringList evaluationFolders;           ///< at least one
  std::size_t absences = 0;  ///< with evaluate: how often the target is taken out of each sequence
  QStringList trackers;      ///< of --tracker; empty: all of them are evaluated
  bool experiments = false;  ///< see experiments_run.h; output is a folder
  QString tracking;          ///< with experiments: sequences with ground truth; empty: none
  QString bench;             ///< with experiments: JSON of the benchmarks; empty: none
  std::optional<std::size_t> sequences;  ///< with experiments: random yards
  std::optional<double> hours;           ///< with experiments: of simulated work
  QString only;                          ///< with experiments: names of some; empty: all
  bool help = false;
  bool version = false;
};

/// Throws Error that names the argument. `arguments` begins with the program's name.
CommandLine parseCommandLine(const QStringList& arguments);

/// The text of --help, made from the parameter table.
QString helpText();

}  // namespace boomwatch
