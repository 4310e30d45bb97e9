#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lab/evaluation/tracker_run.h"
#include "report/text_table.h"

namespace boomwatch {

/// The columns' names, and what stands below them: sequence, tracker and state first.
Cells evaluationTitles();
Cells cellsOf(const TrackerRun& run);
Cells cellsOf(const TrackerMean& mean);

/// What the columns mean; ends with a line feed.
std::string_view evaluationExplanation();

/// The columns' names, for a terminal; ends with a line feed.
std::string tableHeader();
/// One line below tableHeader(), or why there are no numbers; ends with a line feed.
std::string tableLine(const TrackerRun& run);
std::string tableLine(const TrackerMean& mean);

/// A header, every run, then the means as sequence "mean"; fields parted by commas, empty where
/// nothing is known. `state` says whether the numbers are of whole runs: a mean is "complete" only
/// when every run of its tracker is.
std::string csvTable(std::span<const TrackerRun> runs);

/// The same as a page to read, with what the columns mean.
std::string markdownTable(std::span<const TrackerRun> runs);

}  // namespace boomwatch
