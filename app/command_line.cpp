#include "command_line.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <iterator>

#include "base/error.h"
#include "parameters/parameter_text.h"
#include "pipeline/parameter_checks.h"
#include "program/program_arguments.h"
#include "program/program_main.h"
#include "source_guess.h"
#include "tracking/tracker.h"

namespace boomwatch {
namespace {

/// What was an option of boomwatch, or could be taken for a command of it, and where it is now.
constexpr std::array<std::array<const char*, 2>, 13> moved{{
    {"export-demo", "boomwatch-lab export DEMO --output FOLDER"},
    {"export-truth-images", "boomwatch-lab export DEMO --output FOLDER --truth-images"},
    {"evaluate", "boomwatch-lab evaluate FOLDER"},
    {"absences", "boomwatch-lab evaluate FOLDER --absences N"},
    {"experiments", "boomwatch-lab experiments --output REPORT"},
    {"sequences", "boomwatch-lab experiments --output REPORT --sequences N"},
    {"hours", "boomwatch-lab experiments --output REPORT --hours H"},
    {"only", "boomwatch-lab experiments --output REPORT --only NAMES"},
    {"tracking", "boomwatch-lab experiments --output REPORT --tracking PATH"},
    {"bench", "boomwatch-lab experiments --output REPORT --bench FILE"},
    {"export", "boomwatch-lab export DEMO --output FOLDER"},
    {"truth-images", "boomwatch-lab export DEMO --output FOLDER --truth-images"},
    {"lab", "boomwatch-lab --help"},
}};

void failIfMoved(const QString& word, const std::string& asGiven) {
  for (const auto& [name, place] : moved) {
    if (word != QLatin1String(name)) continue;
    throw Error(asGiven, "this is part of the program boomwatch-lab now",
                "Write " + std::string(place) + ".");
  }
}

std::vector<ProgramOption> sourceOptions() {
  return {
      {"source", "ADDRESS",
       "What to open: stereo:PATH, cloud:PATH, depth:PATH, bag:PATH, map:FILE, camera:LEFT,RIGHT, "
       "demo:yard, demo:floor, demo:cylinders or demo:wall"},
      {"calibration", "FILE", "Stereo calibration, when it does not lie with the recording"},
      {"headless", "", "Run without a window; one JSON line a frame"},
      framesOption(),
      {"output", "FILE", "Where the JSON lines go; - is standard output"},
      {"screenshot", "FILE", "Save the whole window as PNG after the last frame"}};
}

std::vector<ProgramOption> toolOptions() {
  return {{"load", "CX,CY,CZ,LX,LY,LZ,YAW,PITCH,ROLL",
           "The load: centre and full sizes along its own x, y, z in metres; yaw about y, then "
           "pitch about x, then roll about z, in degrees"},
          {"tool", "U,V", "Pixel of the left image at which the tool is seen"},
          {"track", "X,Y,W,H",
           "Box of the left image in which the tool is first seen: corner and size in pixels"},
          {"tracker-model", "FILE",
           "Find the tool by this saved model instead of a box; several are merged"},
          {"learn",
           "on|off",
           "Whether the tracker goes on learning what the tool looks like",
           {"on", "off"}},
          {"save-tracker-model", "FILE", "Where to save, at the end, what the tracker learnt"},
          {"tracker",
           "NAME",
           "What follows the tool: tld, cmt, klt, csrt or manual",
           {"tld", "cmt", "klt", "csrt", "manual"}}};
}

void append(std::vector<ProgramOption>& to, std::vector<ProgramOption> more) {
  std::ranges::move(more, std::back_inserter(to));
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

void setTracker(Parameters& parameters, const QCommandLineParser& parser) {
  if (parser.isSet(QStringLiteral("tracker"))) {
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

/// A recording that is named without its kind, as a desktop names the file that was clicked.
void readRecording(CommandLine& line, const QStringList& words) {
  if (words.isEmpty()) return;
  const QString path = words.constFirst();
  const std::string word = path.toStdString();
  failIfMoved(path, word);
  if (!QFileInfo::exists(path)) {
    throw Error("command line", "'" + word + "' is neither an option nor a file or folder",
                "Name a recording with --source KIND:PATH; --help lists the kinds.");
  }
  if (words.size() > 1 || !line.source.isEmpty()) {
    throw Error("command line", "it names '" + word + "' and another recording",
                "Name one recording.");
  }
  // Without a kind, opening it says what to write: in the window, where a person who clicked sees
  // it.
  line.source = guessAddress(path).value_or(path);
}

void readParameters(CommandLine& line, const QCommandLineParser& parser) {
  readPreset(line.parameters, parser);
  if (parser.isSet(QStringLiteral("load"))) {
    setLoad(line.parameters, parser.value(QStringLiteral("load")));
  }
  readSettings(line.parameters, parser);
  setTracker(line.parameters, parser);
  validate(line.parameters);
}

}  // namespace

CommandLine parseCommandLine(const QStringList& arguments) {
  QCommandLineParser parser;
  if (!parseArguments(parser, boomwatchProgram().commands.front(), arguments)) {
    for (const QString& name : parser.unknownOptionNames()) {
      failIfMoved(name, "--" + name.toStdString());
    }
    failOnArguments(parser);
  }
  CommandLine line;
  line.help = parser.isSet(QStringLiteral("help"));
  line.version = parser.isSet(QStringLiteral("version"));
  line.print = parser.value(QStringLiteral("print"));
  line.headless = parser.isSet(QStringLiteral("headless"));
  line.source = parser.value(QStringLiteral("source"));
  line.sourceOptions.calibration = parser.value(QStringLiteral("calibration")).toStdString();
  line.output = parser.value(QStringLiteral("output"));
  line.screenshot = parser.value(QStringLiteral("screenshot"));
  line.frames = countOf(parser, "frames");
  readRecording(line, parser.positionalArguments());
  readTool(line, parser);
  readParameters(line, parser);
  requireLearner(line);
  return line;
}

Program boomwatchProgram() {
  ProgramCommand itself{"", "[PATH]",
                        "Boomwatch tells a remote operator how far the load is from hitting "
                        "something, and whether that number can be trusted. PATH is a "
                        "recording; its names tell what kind of source it is.",
                        sourceOptions()};
  append(itself.options, parameterOptions());
  append(itself.options, toolOptions());
  append(itself.options,
         ownOptions({"parameters", "schema", "man", "completion"},
                    "Print a document that is made from the program's own tables: parameters "
                    "(docs/parameters.md), schema (of a JSON line, docs/result.schema.json), man "
                    "(the manual page) or completion (for bash). For packagers"));
  return {"boomwatch",
          programVersion(),
          "shows how far a crane's load is from the nearest obstacle",
          {std::move(itself)},
          {parameterSection(), yardSection(), exitSection()},
          "boomwatch-lab"};
}

}  // namespace boomwatch
