#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/evaluation/contestant.h"
#include "lab/evaluation/track_score.h"
#include "lab/evaluation/tracking_sequence.h"

namespace boomwatch {

/// How far a tracker came with a sequence.
enum class RunState {
  Complete,     ///< `score` is of the whole sequence, or of as many frames as were asked for
  Failed,       ///< the sequence or the tracker could not be started; see `message`
  Interrupted,  ///< ended before its last frame; no score
};
/// Stable name for files.
std::string_view toString(RunState state);

/// One tracker over one sequence.
struct TrackerRun {
  std::string sequence;
  std::string tracker;
  RunState state = RunState::Complete;
  std::string message;  ///< why it failed
  TrackScore score;     ///< empty unless Complete
};

/// Called before each frame with its number, from 1, and the number of frames; false ends the run.
using EvaluationProgress = std::function<bool(std::size_t frame, std::size_t frames)>;

/// Starts every tracker with the true box in the first frame in which the target is seen, and
/// shows all of them each later frame, up to `frames` in all: one run each, in their order. Throws
/// std::runtime_error naming the picture when one cannot be read.
std::vector<TrackerRun> evaluateSequence(TrackingSequence& sequence,
                                         std::span<const Contestant> trackers,
                                         std::optional<std::size_t> frames,
                                         const EvaluationProgress& progress);

/// A tracker's mean over the sequences it completed.
struct TrackerMean {
  std::string tracker;
  std::size_t complete = 0;  ///< runs in the mean
  std::size_t runs = 0;      ///< runs that were asked for
  TrackScore score;
};

/// One a tracker, in the order in which they first appear.
std::vector<TrackerMean> meansOf(std::span<const TrackerRun> runs);

}  // namespace boomwatch
