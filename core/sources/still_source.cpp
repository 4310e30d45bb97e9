#include "sources/still_source.h"

#include "sources/indexed_source.h"

namespace boomwatch {
namespace {

class StillSource : public IndexedSource {
 public:
  static constexpr std::size_t repeats = 20;
  static constexpr double rate = 10.0;  // Hz

  StillSource(const SourceInfo& of, FramePtr frame)
      : IndexedSource(of.address, repeats, rate), m_frame(std::move(frame)) {
    if (!of.note.empty()) note(of.note);
  }

 private:
  ReadResult read(std::size_t index) override {
    auto frame = std::make_shared<Frame>(*m_frame);
    frame->sequence = index;
    frame->stamp = m_frame->stamp + static_cast<double>(index) / rate;
    frame->still = true;
    return ok(std::move(frame));
  }

  FramePtr m_frame;
};

}  // namespace

std::unique_ptr<FrameSource> repeatIfStill(std::unique_ptr<FrameSource> source) {
  const SourceInfo info = source->info();
  if (info.live || info.frameCount != 1U) return source;
  ReadResult only = source->next(std::chrono::milliseconds(0));
  if (only.status == ReadResult::Status::Ok) {
    return std::make_unique<StillSource>(info, std::move(only.frame));
  }
  source->seek(0);  // so that whoever reads it is told what is wrong, once
  return source;
}

}  // namespace boomwatch
