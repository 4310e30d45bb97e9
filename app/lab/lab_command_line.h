#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <variant>

#include "parameters/parameters.h"
#include "program/program.h"
#include "simulation/demo_export.h"

namespace boomwatch {

/// boomwatch-lab evaluate: trackers over sequences with ground truth.
struct EvaluationOrder {
  QStringList folders;                ///< each a sequence or a folder of such; at least one
  QStringList trackers;               ///< names; empty: all of them
  std::size_t absences = 0;           ///< how often the target is taken out of each sequence
  std::optional<std::size_t> frames;  ///< of each sequence; absent: all
  QString output;                     ///< folder of the tables; empty: none are written
};

/// boomwatch-lab experiments: the thesis's figures and the chain on random yards.
struct ExperimentsOrder {
  Parameters parameters;
  QString output;                        ///< folder of the report
  std::optional<std::size_t> frames;     ///< of each yard
  std::optional<std::size_t> sequences;  ///< random yards
  std::optional<double> hours;           ///< of simulated work
  QString only;                          ///< names of some experiments, by commas; empty: all
  QString tracking;                      ///< sequences with ground truth; empty: none
  QString bench;                         ///< JSON of the benchmarks; empty: none
};

/// Help, version or a document.
struct TextOrder {
  std::string text;
};

using LabOrder = std::variant<TextOrder, DemoExport, EvaluationOrder, ExperimentsOrder>;

/// Throws Error that names the argument. `arguments` begins with the program's name.
LabOrder parseLabCommandLine(const QStringList& arguments);

/// What boomwatch-lab says about itself.
Program labProgram();

}  // namespace boomwatch
