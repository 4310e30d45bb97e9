#include "lab/evaluation/tracker_run.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "base/error.h"

namespace boomwatch {
namespace {

/// One tracker while it is being evaluated.
struct Entry {
  TrackerRun run;
  bool hasConfidence = true;
  std::unique_ptr<Tracker> tracker;  ///< null when it could not be started
  std::vector<TrackedFrame> frames;
};

/// Truth may reach out of the picture a little; a box to begin with may not.
cv::Rect2d insideOf(const cv::Rect2d& box, cv::Size image) {
  return box & cv::Rect2d(0, 0, image.width, image.height);
}

Entry begin(const Contestant& contestant, const std::string& sequence, const cv::Mat& image,
            const cv::Rect2d& box) {
  Entry entry;
  entry.run.sequence = sequence;
  entry.run.tracker = contestant.name;
  entry.hasConfidence = contestant.hasConfidence;
  try {
    entry.tracker = contestant.make();
    entry.tracker->start(image, insideOf(box, image.size()));
  } catch (const Error& error) {
    entry.tracker.reset();
    entry.run.state = RunState::Failed;
    entry.run.message = error.what();
  }
  return entry;
}

cv::Mat pictureOf(ImageStream& images, std::size_t index) {
  StreamImage picture = images.read(index);
  if (picture.image.empty()) throw std::runtime_error(picture.fault);
  return picture.image;
}

void show(Entry& entry, const cv::Mat& image) {
  if (!entry.tracker) return;
  using Clock = std::chrono::steady_clock;
  const auto before = Clock::now();
  Track track = entry.tracker->track(image);
  const std::chrono::duration<double> taken = Clock::now() - before;
  entry.frames.push_back({std::move(track), taken.count()});
}

void finish(Entry& entry, std::span<const std::optional<cv::Rect2d>> truth) {
  if (!entry.tracker) return;
  if (entry.frames.size() == truth.size()) {
    entry.run.score = scoreOf(entry.frames, truth, entry.hasConfidence);
  } else {
    entry.run.state = RunState::Interrupted;
  }
}

}  // namespace

std::string_view toString(RunState state) {
  switch (state) {
    case RunState::Complete:
      return "complete";
    case RunState::Failed:
      return "failed";
    case RunState::Interrupted:
      return "interrupted";
  }
  return "";
}

std::vector<TrackerRun> evaluateSequence(TrackingSequence& sequence,
                                         std::span<const Contestant> trackers,
                                         std::optional<std::size_t> frames,
                                         const EvaluationProgress& progress) {
  const auto& truth = sequence.truth;
  const auto seen = std::ranges::find_if(truth, [](const auto& box) { return box.has_value(); });
  const auto first = static_cast<std::size_t>(seen - truth.begin());
  const std::size_t end = std::min(truth.size(), first + frames.value_or(truth.size()));
  std::vector<Entry> entries;
  const cv::Mat image = pictureOf(*sequence.images, first);
  for (const Contestant& one : trackers) {
    entries.push_back(begin(one, sequence.name, image, *truth[first]));
  }
  for (std::size_t frame = first + 1; frame < end && progress(frame + 1, end); ++frame) {
    const cv::Mat next = pictureOf(*sequence.images, frame);
    for (Entry& entry : entries) show(entry, next);
  }
  std::vector<TrackerRun> runs;
  for (Entry& entry : entries) {
    finish(entry, std::span(truth).subspan(first + 1, end - first - 1));
    runs.push_back(std::move(entry.run));
  }
  return runs;
}

std::vector<TrackerMean> meansOf(std::span<const TrackerRun> runs) {
  std::vector<TrackerMean> means;
  for (const TrackerRun& run : runs) {
    if (std::ranges::find(means, run.tracker, &TrackerMean::tracker) != means.end()) continue;
    TrackerMean mean;
    mean.tracker = run.tracker;
    std::vector<TrackScore> scores;
    for (const TrackerRun& other : runs) {
      if (other.tracker != run.tracker) continue;
      ++mean.runs;
      if (other.state == RunState::Complete) scores.push_back(other.score);
    }
    mean.complete = scores.size();
    mean.score = meanOf(scores);
    means.push_back(std::move(mean));
  }
  return means;
}

}  // namespace boomwatch
