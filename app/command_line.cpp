#include "command_line.h"

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QCoreApplication>
#include <array>

#include "base/error.h"
#include "parameters/parameter_table.h"
#include "parameters/parameter_text.h"
#include "pipeline/parameter_checks.h"
#include "pipeline/preset_file.h"
#include "simulation/yard/yard_options.h"
#include "tracking/tracker.h"

namespace boomwatch {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("CommandLine", text); }

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

template <class Add>
void addExperimentOptions(const Add& option) {
  option(
      "experiments", "",
      tr("Instead of all this, repeat the thesis's experiments and run the chain on random yards "
         "against truth; the report goes into the folder --output; --frames of each yard"));
  option("sequences", "N", tr("With --experiments: how many random yards, 50 by default"));
  option("hours", "H",
         tr("With --experiments: simulated hours in which alarms are counted, 1 by default"));
  option("only", "NAME,...",
         tr("With --experiments: only those named, as the progress names them"));
  option("tracking", "PATH",
         tr("With --experiments: a sequence with ground truth, or a folder of such"));
  option("bench", "FILE",
         tr("With --experiments: figures of FCL and OctoMap, as packaging/dev bench writes them"));
}

void addOptions(QCommandLineParser& parser) {
  const auto option = [&](const char* name, const char* value, const QString& description) {
    parser.addOption(
        QCommandLineOption(QString::fromLatin1(name), description, QString::fromLatin1(value)));
  };
  option(
      "source", "ADDRESS",
      tr("stereo:PATH, cloud:PATH, depth:PATH, map:FILE, camera:LEFT,RIGHT, demo:yard, demo:floor, "
         "demo:cylinders or demo:wall"));
  option("calibration", "FILE", tr("Stereo calibration, when it does not lie with the recording"));
  option("headless", "", tr("Run without a window; one JSON line a frame"));
  option("frames", "N", tr("Stop after N frames"));
  option("output", "FILE", tr("Where the JSON lines go; - is standard output"));
  option("export-demo", "NAME",
         tr("Write a demo (yard, or yard,seed=7,...; floor, cylinders, wall) as a recording with "
            "its truth into the folder --output, --frames of it"));
  option("export-truth-images", "",
         tr("With --export-demo yard: depth, disparity and kinds as images as well"));
  option("screenshot", "FILE", tr("Save the whole window as PNG after the last frame"));
  option("parameters", "FILE", tr("YAML preset with parameters"));
  option("set", "KEY=VALUE", tr("Set one parameter; may be given often, after --parameters"));
  option("load", "CX,CY,CZ,LX,LY,LZ,YAW,PITCH,ROLL",
         tr("The load: centre and full sizes along its own x, y, z in metres; yaw about y, then "
            "pitch about x, then roll about z, in degrees"));
  option("tool", "U,V", tr("Pixel of the left image at which the tool is seen"));
  option("track", "X,Y,W,H",
         tr("Box of the left image in which the tool is first seen: corner and size in pixels"));
  option("tracker-model", "FILE",
         tr("Find the tool by this saved model instead of a box; several are merged"));
  option("learn", "on|off", tr("Whether the tracker goes on learning what the tool looks like"));
  option("save-tracker-model", "FILE", tr("Where to save, at the end, what the tracker learnt"));
  option("tracker", "NAME",
         tr("What follows the tool: tld, cmt, klt, csrt or manual; with --evaluate it may be given "
            "often, and opencv_tld, opencv_csrt and opencv_medianflow are possible too"));
  option("evaluate", "tracking",
         tr("Instead of all this, run trackers over the FOLDERs that follow, each a sequence with "
            "ground truth or a folder of such; --output names a folder for the tables"));
  option("absences", "N",
         tr("With --evaluate: take the target out of each sequence N times for 40 frames, and see "
            "whether it is found again"));
  addExperimentOptions(option);
  parser.addOption(
      QCommandLineOption({QStringLiteral("h"), QStringLiteral("help")}, tr("Show this text")));
  option("version", "", tr("Show the version"));
}

/// `count` numbers, separated by commas; throws Error naming `option`.
QStringList fields(const QString& option, const QString& value, qsizetype count) {
  const QStringList parts = value.split(QLatin1Char(','));
  if (parts.size() == count) return parts;
  throw Error(option.toStdString(),
              "'" + value.toStdString() + "' has " + std::to_string(parts.size()) +
                  " values, not " + std::to_string(count),
              "Separate the values with commas; --help shows their order.");
}

void setLoad(Parameters& parameters, const QString& value) {
  constexpr std::array<const char*, 9> keys{"load_x",      "load_y",      "load_z",
                                            "load_size_x", "load_size_y", "load_size_z",
                                            "load_yaw",    "load_pitch",  "load_roll"};
  const QStringList parts = fields(QStringLiteral("--load"), value, keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    setParameter(parameters, keys[i], parts[static_cast<qsizetype>(i)].trimmed().toStdString());
  }
  parameters.load.source = LoadSource::Manual;
}

int wholeNumber(const QString& option, const QString& value, int minimum) {
  bool valid = false;
  const int number = value.trimmed().toInt(&valid);
  if (valid && number >= minimum) return number;
  throw Error(option.toStdString(),
              "'" + value.toStdString() + "' is not a whole number from " + std::to_string(minimum),
              "Give one.");
}

void setTracker(Parameters& parameters, const QCommandLineParser& parser) {
  // An evaluation knows more of them, and several at a time.
  if (parser.isSet(QStringLiteral("tracker")) && !parser.isSet(QStringLiteral("evaluate"))) {
    setParameter(parameters, "tracker", parser.value(QStringLiteral("tracker")).toStdString());
  }
  if (!parser.isSet(QStringLiteral("learn"))) return;
  const QString learn = parser.value(QStringLiteral("learn"));
  if (learn != QLatin1String("on") && learn != QLatin1String("off")) {
    throw Error("--learn", "'" + learn.toStdString() + "' is neither on nor off",
                "Give one of them.");
  }
  parameters.tracking.learn = learn == QLatin1String("on");
}

/// Tool and tracker: where they begin, and what is kept of them.
void readTool(CommandLine& line, const QCommandLineParser& parser) {
  const auto numbers = [&](const QString& name, qsizetype count, int minSize) {
    const QString option = QStringLiteral("--") + name;
    const QStringList parts = fields(option, parser.value(name), count);
    std::vector<int> values;
    for (const QString& part : parts) {
      values.push_back(wholeNumber(option, part, values.size() < 2 ? 0 : minSize));
    }
    return values;
  };
  if (parser.isSet(QStringLiteral("tool"))) {
    const auto pixel = numbers(QStringLiteral("tool"), 2, 0);
    line.tool = cv::Point(pixel[0], pixel[1]);
  }
  if (parser.isSet(QStringLiteral("track"))) {
    const auto box = numbers(QStringLiteral("track"), 4, static_cast<int>(Tracker::minSide));
    line.track = cv::Rect(box[0], box[1], box[2], box[3]);
  }
  for (const QString& file : parser.values(QStringLiteral("tracker-model"))) {
    line.trackerModels.push_back(file.toStdString());
  }
  line.saveTrackerModel = parser.value(QStringLiteral("save-tracker-model")).toStdString();
  const int beginnings = (line.tool ? 1 : 0) + (line.track ? 1 : 0) + !line.trackerModels.empty();
  if (beginnings > 1) {
    throw Error("--tool, --track and --tracker-model", "each says where the tool is",
                "Give one of them.");
  }
}

/// What cannot come to anything is said before the run, not after it.
void requireLearner(const CommandLine& line) {
  const bool learns = line.parameters.tracking.tracker == TrackerKind::Tld;
  if (!learns && !(line.trackerModels.empty() && line.saveTrackerModel.empty())) {
    throw Error("--tracker-model and --save-tracker-model", "only tld keeps a model of the tool",
                "Leave them out, or give --tracker tld.");
  }
  if (line.parameters.tracking.tracker == TrackerKind::Manual && line.track) {
    throw Error("--track", "the tracker manual follows nothing",
                "Give another --tracker, or --tool U,V.");
  }
}

/// Positional arguments are the folders of an evaluation, and nothing else.
void readEvaluation(CommandLine& line, const QCommandLineParser& parser) {
  line.trackers = parser.values(QStringLiteral("tracker"));
  line.evaluate = parser.isSet(QStringLiteral("evaluate"));
  const QStringList words = parser.positionalArguments();
  if (!line.evaluate) {
    if (parser.isSet(QStringLiteral("absences"))) {
      throw Error("--absences", "nothing is evaluated",
                  "Write --evaluate tracking FOLDER... as well.");
    }
    if (words.isEmpty()) return;
    throw Error("command line", "'" + words.constFirst().toStdString() + "' is no option",
                "Name a recording with --source KIND:PATH; --help lists the kinds.");
  }
  const QString what = parser.value(QStringLiteral("evaluate"));
  if (what != QLatin1String("tracking")) {
    throw Error("--evaluate", "'" + what.toStdString() + "' cannot be evaluated",
                "Write --evaluate tracking FOLDER...");
  }
  if (words.isEmpty()) {
    throw Error("--evaluate", "no folder is named", "Write --evaluate tracking FOLDER...");
  }
  line.evaluationFolders = words;
  if (!parser.isSet(QStringLiteral("absences"))) return;
  line.absences = static_cast<std::size_t>(
      wholeNumber(QStringLiteral("--absences"), parser.value(QStringLiteral("absences")), 1));
}

double hoursOf(const QString& text) {
  bool isNumber = false;
  const double hours = text.toDouble(&isNumber);
  if (isNumber && hours > 0.0 && hours <= 1000.0) return hours;
  throw Error("--hours", "'" + text.toStdString() + "' is not a number above 0, 1000 at most",
              "Write --hours 1.");
}

void readExperiments(CommandLine& line, const QCommandLineParser& parser) {
  line.experiments = parser.isSet(QStringLiteral("experiments"));
  line.tracking = parser.value(QStringLiteral("tracking"));
  line.bench = parser.value(QStringLiteral("bench"));
  if (parser.isSet(QStringLiteral("sequences"))) {
    line.sequences = static_cast<std::size_t>(
        wholeNumber(QStringLiteral("--sequences"), parser.value(QStringLiteral("sequences")), 1));
  }
  line.only = parser.value(QStringLiteral("only"));
  if (parser.isSet(QStringLiteral("hours"))) {
    line.hours = hoursOf(parser.value(QStringLiteral("hours")));
  }
  for (const char* name : {"sequences", "hours", "only", "tracking", "bench"}) {
    if (line.experiments || !parser.isSet(QLatin1String(name))) continue;
    throw Error("--" + std::string(name), "it belongs to --experiments",
                "Add that, or leave it out.");
  }
}

void readParameters(CommandLine& line, const QCommandLineParser& parser) {
  if (parser.isSet(QStringLiteral("parameters"))) {
    line.parameters =
        loadPreset(parser.value(QStringLiteral("parameters")).toStdString(), line.parameters);
  }
  if (parser.isSet(QStringLiteral("load"))) {
    setLoad(line.parameters, parser.value(QStringLiteral("load")));
  }
  for (const QString& setting : parser.values(QStringLiteral("set"))) {
    const qsizetype equals = setting.indexOf(QLatin1Char('='));
    if (equals < 1) {
      throw Error("--set", "'" + setting.toStdString() + "' is not a key, '=' and a value",
                  "Write --set key=value.");
    }
    setParameter(line.parameters, setting.left(equals).trimmed().toStdString(),
                 setting.mid(equals + 1).trimmed().toStdString());
  }
  setTracker(line.parameters, parser);
  validate(line.parameters);
}

}  // namespace

CommandLine parseCommandLine(const QStringList& arguments) {
  QCommandLineParser parser;
  addOptions(parser);
  if (!parser.parse(arguments)) {
    QString fault = parser.errorText();
    while (fault.endsWith(QLatin1Char('.'))) fault.chop(1);
    throw Error("command line", fault.toStdString(), "--help lists the options.");
  }
  CommandLine line;
  line.help = parser.isSet(QStringLiteral("help"));
  line.version = parser.isSet(QStringLiteral("version"));
  line.headless = parser.isSet(QStringLiteral("headless"));
  line.source = parser.value(QStringLiteral("source"));
  line.sourceOptions.calibration = parser.value(QStringLiteral("calibration")).toStdString();
  line.output = parser.value(QStringLiteral("output"));
  line.exportDemo = parser.value(QStringLiteral("export-demo"));
  line.exportTruthImages = parser.isSet(QStringLiteral("export-truth-images"));
  line.screenshot = parser.value(QStringLiteral("screenshot"));
  if (parser.isSet(QStringLiteral("frames"))) {
    line.frames = static_cast<std::size_t>(
        wholeNumber(QStringLiteral("--frames"), parser.value(QStringLiteral("frames")), 1));
  }
  readEvaluation(line, parser);
  readExperiments(line, parser);
  readTool(line, parser);
  readParameters(line, parser);
  requireLearner(line);
  return line;
}

QString helpText() {
  QCommandLineParser parser;
  parser.setApplicationDescription(
      tr("Boomwatch tells a remote operator how far the load is from hitting something, and "
         "whether that number can be trusted."));
  addOptions(parser);
  QString help = parser.helpText();
  help += QLatin1Char('\n') + tr("Parameters (key, range, default):") + QLatin1Char('\n');
  const Parameters defaults;
  for (const ParameterInfo& info : parameterTable()) {
    help += QStringLiteral("  %1 %2 [%3]\n      %4\n")
                .arg(text(info.key), -24)
                .arg(QString::fromStdString(rangeText(info)),
                     QString::fromStdString(formatValue(info, info.get(defaults))),
                     QCoreApplication::translate("Parameters", info.tooltip));
  }
  help += QLatin1Char('\n') +
          tr("Options of demo:yard (key, range, default), as in %1:")
              .arg(QStringLiteral("demo:yard,seed=7,rain=0.5")) +
          QLatin1Char('\n') + QString::fromStdString(yardOptionsHelp());
  help += QLatin1Char('\n') + tr("Exit codes: 0 done, 1 a fault in the run, 2 bad arguments.") +
          QLatin1Char('\n');
  return help;
}

}  // namespace boomwatch
