#include "lab/experiments/yard_stream.h"

#include <algorithm>

#include "lab/experiments/true_tool.h"

namespace boomwatch {
namespace {

constexpr double seenShare = 0.5;

class YardStream : public ImageStream {
 public:
  explicit YardStream(std::unique_ptr<YardSource> source) : m_source(std::move(source)) {}

  std::size_t count() const override { return m_source->info().frameCount.value_or(0); }
  std::optional<double> rate() const override { return m_source->info().nominalRate; }
  std::optional<cv::Size> size() const override { return std::nullopt; }
  StreamImage read(std::size_t index) override {
    if (index >= count()) return {{}, "there is no such frame", true};
    return {m_source->at(index).frame->left, {}, false};
  }

 private:
  std::unique_ptr<YardSource> m_source;
};

}  // namespace

std::optional<TrackingSequence> yardSequence(std::uint64_t seed, std::size_t frames,
                                             const ExperimentProgress& progress) {
  const std::string options =
      "as=cloud,path=random,seed=" + std::to_string(seed) + ",frames=" + std::to_string(frames);
  auto source = std::make_unique<YardSource>(options);
  TrackingSequence sequence;
  sequence.name = "yard, seed " + std::to_string(seed);
  for (std::size_t k = 0; k < frames; ++k) {
    sequence.truth.push_back(toolBoxIn(source->at(k), seenShare));
    if (!progress(static_cast<double>(k + 1) / static_cast<double>(frames))) return std::nullopt;
  }
  const bool any = std::ranges::any_of(sequence.truth, [](const auto& box) { return !!box; });
  if (!any) return std::nullopt;
  sequence.images = std::make_unique<YardStream>(std::move(source));
  return sequence;
}

}  // namespace boomwatch
