#include "lab/lab_command_line.h"

#include <algorithm>
#include <iterator>

#include "base/error.h"
#include "lab/evaluation/contestant.h"
#include "lab/experiments/experiment.h"
#include "pipeline/parameter_checks.h"
#include "program/bash_completion.h"
#include "program/manual_page.h"
#include "program/program_arguments.h"
#include "program/program_help.h"
#include "program/program_main.h"

namespace boomwatch {
namespace {

ProgramCommand labItself() {
  return {"", "COMMAND",
          "Exports simulated scenes, evaluates trackers and repeats experiments for Boomwatch.",
          ownOptions({"man", "completion"},
                     "Print a document that is made from the program's own tables: man (the manual "
                     "page) or completion (for bash). For packagers")};
}

ProgramCommand exportCommand() {
  return {"export",
          "DEMO",
          "Writes a demo (yard, or yard,seed=7,...; floor, cylinders, wall) as a recording with "
          "its truth.",
          {{"frames", "N", "How many frames, all by default"},
           {"output", "FOLDER", "Where the recording goes: a new or an empty folder"},
           {"truth-images", "",
            "Of a yard, also write depth, disparity and kinds of objects as images"},
           helpOption()},
          {"yard", "floor", "cylinders", "wall"}};
}

std::vector<std::string> trackerNames() {
  std::vector<std::string> names;
  for (const Contestant& one : contestants()) names.push_back(one.name);
  return names;
}

ProgramCommand evaluateCommand() {
  return {
      "evaluate",
      "FOLDER...",
      "Runs trackers over recordings. Each FOLDER is a sequence with ground truth, or a folder "
      "of such. The word 'tracking' may stand before them.",
      {{"tracker", "NAME", "A tracker; may be given often, all of them by default", trackerNames()},
       {"absences", "N",
        "Take the target out of each sequence N times for 40 frames, and report whether the "
        "tracker finds it again"},
       {"frames", "N", "How many frames of each sequence, all by default"},
       {"output", "FOLDER", "Where tracking.csv and tracking.md go"},
       helpOption()}};
}

ProgramCommand experimentsCommand() {
  ProgramCommand command{
      "experiments",
      "",
      "Repeats the thesis's experiments, runs the whole chain on random yards against their truth, "
      "and writes a report.",
      {{"output", "FOLDER", "Where the report goes: a new or an empty folder"},
       {"sequences", "N", "How many random yards, 50 by default"},
       {"frames", "N", "How many frames of each yard, 200 by default"},
       {"hours", "H", "Simulated hours in which alarms are counted, 1 by default"},
       {"only", "NAME,...", "Some experiments, by the names that the progress shows"},
       {"tracking", "PATH", "A sequence with ground truth, or a folder of such"},
       {"bench", "FILE", "Figures of FCL and OctoMap, as packaging/dev bench writes them"}}};
  std::ranges::move(parameterOptions(), std::back_inserter(command.options));
  command.options.push_back(helpOption());
  return command;
}

DemoExport readExport(const QCommandLineParser& parser) {
  const QStringList demos = parser.positionalArguments();
  if (demos.size() != 1) {
    throw Error("export", std::to_string(demos.size()) + " demos are named, not one",
                "Write boomwatch-lab export DEMO --output FOLDER.");
  }
  return {demos.constFirst().toStdString(), countOf(parser, "frames"),
          parser.value(QStringLiteral("output")).toStdString(),
          parser.isSet(QStringLiteral("truth-images"))};
}

EvaluationOrder readEvaluation(const QCommandLineParser& parser) {
  EvaluationOrder order;
  order.folders = parser.positionalArguments();
  if (order.folders.value(0) == QLatin1String("tracking")) order.folders.removeFirst();
  if (order.folders.isEmpty()) {
    throw Error("evaluate", "no folder is named", "Write boomwatch-lab evaluate FOLDER...");
  }
  order.trackers = parser.values(QStringLiteral("tracker"));
  order.absences = countOf(parser, "absences").value_or(0);
  order.frames = countOf(parser, "frames");
  order.output = parser.value(QStringLiteral("output"));
  return order;
}

std::optional<double> hoursOf(const QCommandLineParser& parser) {
  const QString option = QStringLiteral("hours");
  if (!parser.isSet(option)) return std::nullopt;
  bool isNumber = false;
  const QString text = parser.value(option);
  const double hours = text.toDouble(&isNumber);
  if (isNumber && hours > 0.0 && hours <= 1000.0) return hours;
  throw Error("--hours", "'" + text.toStdString() + "' is not a number above 0, 1000 at most",
              "Write --hours 1.");
}

ExperimentsOrder readExperiments(const QCommandLineParser& parser) {
  if (!parser.positionalArguments().isEmpty()) {
    throw Error("experiments",
                "'" + parser.positionalArguments().constFirst().toStdString() + "' is no option",
                "Write boomwatch-lab experiments --output REPORT; --only names experiments.");
  }
  ExperimentsOrder order;
  readPreset(order.parameters, parser);
  readSettings(order.parameters, parser);
  validate(order.parameters);
  order.output = parser.value(QStringLiteral("output"));
  order.frames = countOf(parser, "frames");
  order.sequences = countOf(parser, "sequences");
  order.hours = hoursOf(parser);
  order.only = parser.value(QStringLiteral("only"));
  order.tracking = parser.value(QStringLiteral("tracking"));
  order.bench = parser.value(QStringLiteral("bench"));
  return order;
}

TextOrder documentNamed(const std::string& name) {
  if (name == "man") return {manualPage(labProgram())};
  if (name == "completion") return {bashCompletion(labProgram())};
  throw Error("--print", "there is no document '" + name + "'", "Give man or completion.");
}

/// Without a command.
TextOrder readItself(const QCommandLineParser& parser) {
  if (parser.isSet(QStringLiteral("help"))) return {helpText(labProgram())};
  if (parser.isSet(QStringLiteral("version"))) return {"boomwatch-lab " + programVersion() + '\n'};
  if (parser.isSet(QStringLiteral("print"))) {
    return documentNamed(parser.value(QStringLiteral("print")).toStdString());
  }
  throw Error("command line", "no command is named",
              "Write boomwatch-lab export, evaluate or experiments; --help explains them.");
}

}  // namespace

LabOrder parseLabCommandLine(const QStringList& arguments) {
  const Program program = labProgram();
  QStringList rest = arguments;
  QString name;
  if (rest.size() > 1 && !rest[1].startsWith(QLatin1Char('-'))) name = rest.takeAt(1);
  const ProgramCommand* command = program.find(name.toStdString());
  if (command == nullptr) {
    throw Error("command line", "there is no command '" + name.toStdString() + "'",
                "Give export, evaluate or experiments; --help explains them.");
  }
  QCommandLineParser parser;
  if (!parseArguments(parser, *command, rest)) failOnArguments(parser);
  if (name.isEmpty()) return readItself(parser);
  if (parser.isSet(QStringLiteral("help"))) return TextOrder{helpText(program, *command)};
  if (command->name == "export") return readExport(parser);
  if (command->name == "evaluate") return readEvaluation(parser);
  return readExperiments(parser);
}

Program labProgram() {
  return {"boomwatch-lab",
          programVersion(),
          "exports simulated scenes, evaluates trackers and repeats experiments for Boomwatch",
          {labItself(), exportCommand(), evaluateCommand(), experimentsCommand()},
          {yardSection(), exitSection()},
          "boomwatch"};
}

}  // namespace boomwatch
