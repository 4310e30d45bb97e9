#include "lab/evaluate.h"

#include <QDir>
#include <QSaveFile>
#include <QTemporaryFile>
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "base/error.h"
#include "lab/evaluation/absences.h"
#include "lab/evaluation/evaluation_table.h"
#include "lab/evaluation/tracker_run.h"
#include "lab/evaluation/tracking_sequence.h"
#include "program/interrupt_watch.h"

namespace boomwatch {
namespace {

void complain(const std::string& message) {
  std::fprintf(stderr, "boomwatch-lab: %s\n", message.c_str());
}

/// Before the hours of work, not after them.
void requireWritable(const QString& folder) {
  QTemporaryFile file(QDir(folder).filePath(QStringLiteral("tracking.XXXXXX")));
  if (QDir().mkpath(folder) && file.open()) return;
  throw Error(folder.toStdString(), "it is no folder that can be written",
              "Name another with --output.");
}

void write(const QString& folder, const char* name, const std::string& text) {
  QSaveFile file(QDir(folder).filePath(QLatin1String(name)));
  if (file.open(QIODevice::WriteOnly) && file.write(text.data(), qint64(text.size())) >= 0 &&
      file.commit()) {
    return;
  }
  throw std::runtime_error(file.fileName().toStdString() + ": " + file.errorString().toStdString() +
                           ". Free some space or name another folder with --output.");
}

class Evaluation {
 public:
  explicit Evaluation(const EvaluationOrder& order) : m_order(order) {
    std::vector<std::string> names;
    for (const QString& name : order.trackers) names.push_back(name.toStdString());
    m_trackers = contestantsNamed(names);
    for (const QString& path : order.folders) {
      for (auto& folder : trackingSequencesIn(path.toStdString())) m_folders.push_back(folder);
    }
    if (!order.output.isEmpty()) requireWritable(order.output);
  }

  int run() {
    const InterruptWatch watch;
    print(tableHeader());
    for (std::size_t i = 0; i < m_folders.size(); ++i) add(runsOf(i));
    for (const TrackerMean& mean : meansOf(m_runs)) print(tableLine(mean));
    if (!m_order.output.isEmpty()) {
      write(m_order.output, "tracking.csv", csvTable(m_runs));
      write(m_order.output, "tracking.md", markdownTable(m_runs));
    }
    if (InterruptWatch::interrupted())
      complain("interrupted: only rows that say complete are whole.");
    return std::ranges::all_of(
               m_runs, [](const TrackerRun& run) { return run.state == RunState::Complete; })
               ? 0
               : 1;
  }

 private:
  static void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
  }

  std::vector<TrackerRun> runsOf(std::size_t index) {
    const std::string name = m_folders[index].filename().string();
    if (InterruptWatch::interrupted()) return without(name, RunState::Interrupted, "");
    try {
      TrackingSequence sequence = openTrackingSequence(m_folders[index]);
      if (m_order.absences > 0) addAbsences(sequence, m_order.absences, m_order.frames);
      return evaluateSequence(sequence, m_trackers, m_order.frames,
                              [&](std::size_t frame, std::size_t frames) {
                                sayProgress(index, sequence.name, frame, frames);
                                return !InterruptWatch::interrupted();
                              });
    } catch (const std::exception& fault) {
      complain(fault.what());
      return without(name, RunState::Failed, fault.what());
    }
  }

  /// Every tracker without numbers.
  std::vector<TrackerRun> without(const std::string& sequence, RunState state,
                                  const std::string& message) const {
    std::vector<TrackerRun> runs;
    for (const Contestant& one : m_trackers) {
      runs.push_back({sequence, one.name, state, message, {}});
    }
    return runs;
  }

  void sayProgress(std::size_t index, const std::string& name, std::size_t frame,
                   std::size_t frames) const {
    constexpr std::size_t interval = 50;
    if (frame % interval != 0 && frame != frames) return;
    std::fprintf(stderr, "sequence %zu of %zu (%s), frame %zu of %zu\n", index + 1,
                 m_folders.size(), name.c_str(), frame, frames);
  }

  void add(const std::vector<TrackerRun>& runs) {
    for (const TrackerRun& run : runs) print(tableLine(run));
    m_runs.insert(m_runs.end(), runs.begin(), runs.end());
  }

  const EvaluationOrder& m_order;
  std::vector<Contestant> m_trackers;
  std::vector<std::filesystem::path> m_folders;
  std::vector<TrackerRun> m_runs;
};

}  // namespace

int runEvaluation(const EvaluationOrder& order) { return Evaluation(order).run(); }

}  // namespace boomwatch
