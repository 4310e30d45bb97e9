#include "lab/evaluation/absences.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lab/evaluation/track_score.h"

namespace boomwatch {
namespace {

// Truth is drawn tightly, and what is left of a rim would still be the target.
constexpr double margin = 0.15;  // of the box, on each side

cv::Rect grown(const cv::Rect2d& box) {
  const cv::Size2d more(box.width * margin, box.height * margin);
  return cv::Rect2d(box.x - more.width, box.y - more.height, box.width + 2 * more.width,
                    box.height + 2 * more.height);
}

/// What lies beside the target, right, left, below or above, whichever the picture shows most of.
void paintOver(cv::Mat& image, const cv::Rect2d& target) {
  const cv::Rect picture({}, image.size()), box = grown(target);
  const std::array<cv::Point, 4> steps{cv::Point(box.width, 0), cv::Point(-box.width, 0),
                                       cv::Point(0, box.height), cv::Point(0, -box.height)};
  const auto visible = [&](const cv::Point& step) {
    return ((box & picture) & ((picture - step))).area();
  };
  const cv::Point step = *std::ranges::max_element(steps, {}, visible);
  const cv::Rect part = box & picture & (picture - step);
  // Where nothing is beside it: grey as the picture is.
  image(box & picture).setTo(cv::mean(image));
  if (!part.empty()) image(part + step).copyTo(image(part));
}

/// A recording in which the target is painted over wherever a box says so.
class WithoutTarget : public ImageStream {
 public:
  WithoutTarget(std::unique_ptr<ImageStream> images, GroundTruth hidden)
      : m_images(std::move(images)), m_hidden(std::move(hidden)) {}
  std::size_t count() const override { return m_images->count(); }
  std::optional<double> rate() const override { return m_images->rate(); }
  std::optional<cv::Size> size() const override { return m_images->size(); }
  StreamImage read(std::size_t index) override {
    StreamImage picture = m_images->read(index);
    if (picture.image.empty() || index >= m_hidden.size() || !m_hidden[index]) return picture;
    picture.image = picture.image.clone();
    paintOver(picture.image, *m_hidden[index]);
    return picture;
  }

 private:
  std::unique_ptr<ImageStream> m_images;
  GroundTruth m_hidden;
};

}  // namespace

void addAbsences(TrackingSequence& sequence, std::size_t count, std::optional<std::size_t> frames) {
  GroundTruth& truth = sequence.truth;
  const auto seen = [](const std::optional<cv::Rect2d>& box) { return box.has_value(); };
  const auto first = static_cast<std::size_t>(std::ranges::find_if(truth, seen) - truth.begin());
  const std::size_t length = std::min(truth.size() - first, frames.value_or(truth.size()));
  GroundTruth hidden(truth.size());
  count = std::min(count, length);  // no two begin at one frame
  for (std::size_t k = 1; k <= count; ++k) {
    const std::size_t begin = first + k * length / (count + 1), end = begin + absenceLength;
    if (end + refoundWithin > first + length || begin == first) continue;
    const auto before = truth.begin() + static_cast<std::ptrdiff_t>(begin) - 1;
    const auto back = truth.begin() + static_cast<std::ptrdiff_t>(end);
    if (!*before || !std::all_of(back, back + refoundWithin, seen)) continue;
    for (std::size_t frame = begin; frame < end; ++frame) {
      hidden[frame] = std::exchange(truth[frame], std::nullopt);
    }
  }
  sequence.name += "+absences";
  sequence.images = std::make_unique<WithoutTarget>(std::move(sequence.images), std::move(hidden));
}

}  // namespace boomwatch
