#include "lab/evaluation/evaluation_table.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "report/text_table.h"

namespace boomwatch {
namespace {

struct Column {
  std::string_view key;    ///< in CSV
  std::string_view title;  ///< for people
  std::size_t width;       ///< in a terminal
};
constexpr std::array columns{Column{"sequence", "sequence", 18},
                             Column{"tracker", "tracker", 18},
                             Column{"state", "state", 12},
                             Column{"frames", "frames", 6},
                             Column{"lost", "lost", 6},
                             Column{"lost_percent", "lost %", 6},
                             Column{"occluded", "occl.", 5},
                             Column{"accuracy_percent", "acc. %", 6},
                             Column{"confidence_mean", "conf.", 6},
                             Column{"confidence_deviation", "dev.", 6},
                             Column{"fps", "fps", 7},
                             Column{"success_auc", "AUC", 6},
                             Column{"precision_20px_percent", "prec. %", 7},
                             Column{"false_boxes", "false", 5},
                             Column{"returns", "back", 4},
                             Column{"found_again", "found", 5},
                             Column{"followed_before", "foll.", 5},
                             Column{"followed_found_again", "again", 5}};
constexpr std::size_t nameColumns = 3;

constexpr std::string_view explanation =
    "The first five numbers, confidence and fps are those of Table 5 of the thesis: frames after "
    "the one whose box was given; frames without a box; frames in which the target cannot be seen "
    "(occl.); the share of the others that have a box, whether it is right or not (acc.); mean and "
    "standard deviation of the confidence, and mean of 1/t, over the frames with a box. AUC is the "
    "mean share of boxes whose overlap with the truth is above 0, 0.05, ... 1; prec. the share "
    "whose "
    "centre is at most 20 pixels off; both count a missing box as wrong. false: boxes given while "
    "the target cannot be seen. back, found: how often it came back into sight, and how often it "
    "was found within 15 frames (overlap at least 0.25). foll., again: the same of those times in "
    "which the tracker was on the target when it went out of sight; what was lost before, is not "
    "found again. The last rows are means over sequences; counts are added up. csrt and "
    "opencv_csrt are the same engine; ours says when it is lost.\n";

void addNumbers(Cells& cells, const TrackScore& score) {
  constexpr double percent = 100.0;
  for (std::string& cell :
       Cells{std::to_string(score.frames), std::to_string(score.lost),
             fixedText(score.lostShare, 1, percent), std::to_string(score.occluded),
             fixedText(score.accuracy, 1, percent), fixedText(score.confidenceMean, 3),
             fixedText(score.confidenceSpread, 3), fixedText(score.fps, 1),
             fixedText(score.successArea, 3), fixedText(score.precision, 1, percent),
             std::to_string(score.falseBoxes), std::to_string(score.returns),
             std::to_string(score.refound), std::to_string(score.followed),
             std::to_string(score.followedRefound)}) {
    cells.push_back(std::move(cell));
  }
}

std::string terminalLine(const Cells& cells) {
  std::string line;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string text = cells[i].empty() ? "-" : cells[i];
    const std::string gap(columns[i].width - std::min(columns[i].width, text.size()), ' ');
    line += i < nameColumns ? text + gap : gap + text;
    line += i + 1 < columns.size() ? ' ' : '\n';
  }
  return line;
}

Cells headings(std::string_view Column::*name) {
  Cells cells;
  for (const Column& column : columns) cells.emplace_back(column.*name);
  return cells;
}

}  // namespace

Cells evaluationTitles() { return headings(&Column::title); }

std::string_view evaluationExplanation() { return explanation; }

Cells cellsOf(const TrackerRun& run) {
  Cells cells{run.sequence, run.tracker, std::string(toString(run.state))};
  if (run.state == RunState::Complete) addNumbers(cells, run.score);
  cells.resize(columns.size());
  return cells;
}

Cells cellsOf(const TrackerMean& mean) {
  const bool whole = mean.complete == mean.runs;
  Cells cells{
      "mean", mean.tracker,
      whole ? "complete" : std::to_string(mean.complete) + " of " + std::to_string(mean.runs)};
  if (mean.complete > 0) addNumbers(cells, mean.score);
  cells.resize(columns.size());
  return cells;
}

std::string tableHeader() { return terminalLine(headings(&Column::title)); }

std::string tableLine(const TrackerRun& run) {
  std::string line = terminalLine(cellsOf(run));
  if (!run.message.empty()) line.append("  ").append(run.message).append("\n");
  return line;
}

std::string tableLine(const TrackerMean& mean) { return terminalLine(cellsOf(mean)); }

std::string csvTable(std::span<const TrackerRun> runs) {
  std::string text = csvLine(headings(&Column::key));
  for (const TrackerRun& run : runs) text += csvLine(cellsOf(run));
  for (const TrackerMean& mean : meansOf(runs)) text += csvLine(cellsOf(mean));
  return text;
}

std::string markdownTable(std::span<const TrackerRun> runs) {
  std::string text = "# Trackers over sequences with ground truth\n\n";
  text.append(explanation).append("\n").append(markdownLine(headings(&Column::title)));
  text += markdownRule(columns.size(), nameColumns);
  for (const TrackerRun& run : runs) text += markdownLine(cellsOf(run));
  for (const TrackerMean& mean : meansOf(runs)) text += markdownLine(cellsOf(mean));
  for (const TrackerRun& run : runs) {
    if (run.message.empty()) continue;
    text.append("\n").append(run.sequence).append(", ").append(run.tracker);
    text.append(": ").append(run.message).append("\n");
  }
  return text;
}

}  // namespace boomwatch
