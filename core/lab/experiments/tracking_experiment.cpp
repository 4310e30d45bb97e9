#include "lab/experiments/experiments.h"

#include <algorithm>
#include <stdexcept>

#include "lab/evaluation/absences.h"
#include "lab/evaluation/evaluation_table.h"
#include "lab/evaluation/tracker_run.h"
#include "lab/experiments/yard_stream.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxYards = 3;
constexpr std::size_t absences = 4;  // of the tool, in each yard
const std::vector<std::string> ours{"tld", "cmt", "klt", "csrt"};

/// Table 5 as it is printed, in the columns of our own.
std::vector<Cells> thesisRows() {
  const auto row = [](const char* set, const char* frames, const char* lost, const char* share,
                      const char* occluded, const char* accuracy, const char* mean,
                      const char* deviation, const char* fps) {
    return Cells{set,      "thesis: TLD", "complete", frames,    lost, share,
                 occluded, accuracy,      mean,       deviation, fps};
  };
  return {row("dataset 1", "46", "0", "0", "0", "100.0", "0.6464", "0.0581", "18.33"),
          row("dataset 2", "334", "38", "8.0", "0", "92.0", "0.5570", "0.2102", "17.92"),
          row("dataset 3", "475", "1", "0.2", "1", "100.0", "0.7068", "0.0738", "18.14"),
          row("dataset 4", "531", "55", "10.4", "46", "98.3", "0.6438", "0.1155", "19.34"),
          row("mean", "1386", "94", "6.8", "47", "96.6", "0.6385", "0.1144", "18.43")};
}

Table tableOf(const char* file, const char* caption, const std::vector<TrackerRun>& runs,
              bool withThesis) {
  Table table{file, caption, evaluationTitles(), {}, 3};
  if (withThesis) table.rows = thesisRows();
  for (const TrackerRun& run : runs) table.rows.push_back(cellsOf(run));
  for (const TrackerMean& mean : meansOf(runs)) table.rows.push_back(cellsOf(mean));
  for (Cells& row : table.rows) row.resize(table.headings.size());
  return table;
}

/// The runs over one sequence; false when the progress said no.
bool evaluate(TrackingSequence& sequence, std::optional<std::size_t> frames,
              const std::vector<Contestant>& trackers, const ExperimentProgress& progress,
              std::vector<TrackerRun>& runs) {
  bool goOn = true;
  for (TrackerRun& run :
       evaluateSequence(sequence, trackers, frames, [&](std::size_t frame, std::size_t all) {
         return goOn = progress(static_cast<double>(frame) / static_cast<double>(all));
       })) {
    runs.push_back(std::move(run));
  }
  return goOn;
}

void addFailure(std::vector<TrackerRun>& runs, const std::filesystem::path& folder,
                const std::vector<Contestant>& trackers, const char* why) {
  for (const Contestant& tracker : trackers) {
    runs.push_back({folder.filename().string(), tracker.name, RunState::Failed, why, {}});
  }
}

}  // namespace

std::optional<Chapter> runTrackingExperiment(const ExperimentSetup& setup,
                                             const ExperimentProgress& progress) {
  const std::vector<Contestant> trackers = contestantsNamed(ours);
  const std::size_t yards = std::min(setup.sequences, maxYards);
  const auto parts = static_cast<double>(setup.recordings.size() + 3 * yards);
  double done = 0.0;
  const ExperimentProgress part = [&](double share) { return progress((done + share) / parts); };
  std::vector<TrackerRun> recorded, simulated, away;
  for (const auto& folder : setup.recordings) {
    try {
      TrackingSequence sequence = openTrackingSequence(folder);
      if (!evaluate(sequence, setup.frames, trackers, part, recorded)) return std::nullopt;
    } catch (const std::exception& fault) {
      addFailure(recorded, folder, trackers, fault.what());
    }
    ++done;
  }
  for (std::size_t k = 0; k < yards; ++k) {
    auto sequence = yardSequence(setup.firstSeed + k, setup.framesOfAYard(), part);
    if (!progress(++done / parts)) return std::nullopt;
    if (sequence && !evaluate(*sequence, {}, trackers, part, simulated)) return std::nullopt;
    ++done;
    if (sequence) addAbsences(*sequence, absences);
    if (sequence && !evaluate(*sequence, {}, trackers, part, away)) return std::nullopt;
    ++done;
  }
  Chapter chapter{"Table 5: tracking the tool", {}};
  chapter.items.emplace_back(
      std::string(evaluationExplanation()) +
      "\nThe thesis's own recordings are not public: its rows are printed for comparison of the "
      "order of magnitude only. It let TLD learn beforehand and switched learning off; here every "
      "tracker begins with the true box of the first frame and goes on learning.");
  if (setup.recordings.empty()) {
    chapter.items.emplace_back("No recordings were named: `--tracking PATH` runs them.");
  }
  chapter.items.emplace_back(tableOf(
      "tracking_recordings", "The thesis's Table 5, and published recordings.", recorded, true));
  chapter.items.emplace_back(tableOf("tracking_yard",
                                     "The tool of the simulated yard, followed from its true box.",
                                     simulated, false));
  chapter.items.emplace_back(tableOf(
      "tracking_absences",
      "The same yards; the tool is taken out of the pictures for two seconds, again and again, and "
      "comes back elsewhere and turned.",
      away, false));
  return chapter;
}

}  // namespace boomwatch
