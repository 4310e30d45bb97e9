#pragma once

#include <span>

#include "lab/experiments/chain_stage.h"
#include "report/chapter.h"

namespace boomwatch {

/// One stage over one sequence.
struct ChainRun {
  ChainKind kind = ChainKind::TruthCloud;
  std::uint64_t seed = 0;
  std::vector<ChainFrame> frames;
};

/// Of distanceErrors, metres: bias, |e| 50 %, 95 % and 99 %; then percent more than 10 cm too far
/// and too near.
Cells errorCells(const std::vector<double>& errors);

/// Error of the reported clearance, by stage and by band of the true distance; see distanceErrors.
Table chainErrors(std::span<const ChainRun> runs, bool againstSeen);

/// What is counted as a missed and as a false alarm. Markdown.
std::string alarmDefinitions(const WarningParameters& warning);

/// Missed and false alarms by stage.
Table chainAlarms(std::span<const ChainRun> runs, const WarningParameters& warning);

/// Every one of them: where, for how long, and what stood where the chain had its nearest point.
Table chainFaults(std::span<const ChainRun> runs, const WarningParameters& warning);

/// How often there was no distance, and why.
Table chainReasons(std::span<const ChainRun> runs);

/// Every frame, for a file.
Table chainFrames(std::span<const ChainRun> runs);

/// Reported distance and truth against time.
Figure chainFigure(const ChainRun& run, const WarningParameters& warning);

}  // namespace boomwatch
