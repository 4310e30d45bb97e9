#include "lab/experiments_run.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cstdio>
#include <opencv2/core/utility.hpp>

#include "base/error.h"
#include "lab/evaluation/tracking_sequence.h"
#include "lab/experiments/experiment.h"
#include "lab/report_writer.h"
#include "parameters/parameter_table.h"
#include "parameters/parameter_text.h"
#include "program/interrupt_watch.h"
#include "simulation/yard/yard_options.h"

namespace boomwatch {
namespace {

/// So many at most at work, on whatever machine.
constexpr int threads = 2;

std::vector<BenchFigure> benchIn(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    throw Error(path.toStdString(), file.errorString().toStdString(),
                "Name the build/bench.json that packaging/dev bench writes.");
  }
  QJsonParseError fault;
  const QJsonDocument document = QJsonDocument::fromJson(file.readAll(), &fault);
  std::vector<BenchFigure> figures;
  for (const QJsonValue value : document.array()) {
    const QJsonObject figure = value.toObject();
    if (figure["name"].isString() && figure["value"].isDouble()) {
      figures.push_back({figure["name"].toString().toStdString(), figure["value"].toDouble(),
                         figure["unit"].toString().toStdString()});
    }
  }
  if (!figures.empty()) return figures;
  throw Error(path.toStdString(), "it holds no figures of the benchmarks",
              "Name the build/bench.json that packaging/dev bench writes.");
}

/// Now, not after an hour.
void requireYards(const ExperimentSetup& setup) {
  parseYardOptions("seed=" + std::to_string(setup.lastSeed()), "--sequences, --hours");
  parseYardOptions("frames=" + std::to_string(setup.framesOfAYard()), "--frames");
}

ExperimentSetup setupOf(const ExperimentsOrder& order) {
  ExperimentSetup setup;
  setup.parameters = order.parameters;
  setup.sequences = order.sequences.value_or(setup.sequences);
  setup.frames = order.frames;
  setup.hours = order.hours.value_or(setup.hours);
  requireYards(setup);
  if (!order.bench.isEmpty()) setup.bench = benchIn(order.bench);
  if (!order.tracking.isEmpty())
    setup.recordings = trackingSequencesIn(order.tracking.toStdString());
  return setup;
}

/// All, or those that --only names, in the order of the report.
std::vector<Experiment> chosen(const QString& only) {
  if (only.isEmpty()) return experiments();
  QStringList names = only.split(QLatin1Char(','));
  for (QString& name : names) name = name.trimmed();
  std::vector<Experiment> some;
  std::string known;
  for (const Experiment& one : experiments()) {
    known.append(known.empty() ? "" : ", ").append(one.name);
    const auto name = QString::fromUtf8(one.name.data(), static_cast<qsizetype>(one.name.size()));
    if (names.removeAll(name) > 0) some.push_back(one);
  }
  if (names.isEmpty()) return some;
  throw Error("--only", "there is no experiment '" + names.constFirst().toStdString() + "'",
              "There are: " + known + ".");
}

/// What differs from the defaults, as --set takes it.
std::string settingsOf(const Parameters& parameters) {
  const Parameters defaults;
  std::string text;
  for (const ParameterInfo& info : parameterTable()) {
    const std::string value = formatValue(info, info.get(parameters));
    if (value == formatValue(info, info.get(defaults))) continue;
    text.append(text.empty() ? "`" : ", `").append(info.key).append("=").append(value).append("`");
  }
  return text.empty() ? "all parameters at their defaults" : "defaults, but " + text;
}

std::string everyParameter(const Parameters& parameters) {
  std::string text = "```yaml\n";
  for (const ParameterInfo& info : parameterTable()) {
    text.append(info.key).append(": ").append(formatValue(info, info.get(parameters)));
    text += '\n';
  }
  return text + "```";
}

std::string introduction(const ExperimentSetup& setup, const std::string& version) {
  return "Boomwatch " + version + ", " + settingsOf(setup.parameters) + "; " +
         std::to_string(setup.sequences) + " random yards from seed " +
         std::to_string(setup.firstSeed) + ", " + std::to_string(setup.framesOfAYard()) +
         " frames each. The same command gives the same figures on any machine, but for times "
         "(of this machine, " +
         std::to_string(threads) +
         " threads at most) and, in the last digits, for what compilers and libraries round "
         "differently. Every table and figure lies beside this page as CSV, figures as PNG.";
}

/// One line on standard error, at whole percents.
class ProgressLine {
 public:
  void begin(std::size_t index, std::size_t all, std::string_view name) {
    m_head = std::to_string(index + 1) + " of " + std::to_string(all) + ", " + std::string(name);
    m_percent = -1;
    say(0.0);
  }
  bool say(double share) {
    const int percent = static_cast<int>(100.0 * share);
    if (percent != m_percent) {
      m_percent = percent;
      std::fprintf(stderr, "\rboomwatch-lab: experiment %s: %3d %%   ", m_head.c_str(), percent);
      std::fflush(stderr);
    }
    return !InterruptWatch::interrupted();
  }
  static void end() { std::fputc('\n', stderr); }

 private:
  std::string m_head;
  int m_percent = -1;
};

/// False when it was stopped.
bool writeChapters(ReportWriter& writer, const ExperimentSetup& setup,
                   const std::vector<Experiment>& all) {
  ProgressLine line;
  for (std::size_t k = 0; k < all.size(); ++k) {
    line.begin(k, all.size(), all[k].name);
    const auto chapter = all[k].run(setup, [&](double share) { return line.say(share); });
    if (!chapter || InterruptWatch::interrupted()) return false;
    ProgressLine::end();
    writer.add(*chapter);
  }
  return true;
}

}  // namespace

int runExperiments(const ExperimentsOrder& order, const std::string& version) {
  const ExperimentSetup setup = setupOf(order);
  const std::vector<Experiment> wanted = chosen(order.only);
  const std::filesystem::path target = emptyFolder(order.output.toStdString());
  PartialFolder folder(target);
  const InterruptWatch watch;
  cv::setNumThreads(threads);
  ReportWriter writer(folder, "Experiments");
  writer.add(introduction(setup, version));
  if (!writeChapters(writer, setup, wanted)) {
    std::fprintf(stderr, "\nboomwatch-lab: stopped; nothing is left of %s\n", target.c_str());
    return 1;
  }
  writer.add(Chapter{"Parameters", {everyParameter(setup.parameters)}});
  writer.close();
  folder.finish();
  std::fprintf(stderr, "boomwatch-lab: %s is written\n", (target / "report.md").c_str());
  return 0;
}

}  // namespace boomwatch
