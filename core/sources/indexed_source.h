#pragma once

#include "sources/frame_source.h"

namespace boomwatch {

/// A recording whose frames can be read in any order: what next() and seek() have in common.
class IndexedSource : public FrameSource {
 public:
  SourceInfo info() const override { return m_info; }

  ReadResult next(std::chrono::milliseconds) override {
    if (m_next >= *m_info.frameCount) return end();
    ReadResult result = read(m_next);
    if (result.status != ReadResult::Status::End) ++m_next;
    return result;
  }

  bool seek(std::size_t index) override {
    if (index >= *m_info.frameCount) return false;
    m_next = index;
    return true;
  }

 protected:
  IndexedSource(std::string address, std::size_t frames, double rate)
      : m_info{std::move(address), frames, rate, false} {}

  /// Adds a sentence to what info() says.
  void note(const std::string& sentence) {
    m_info.note += (m_info.note.empty() ? "" : " ") + sentence;
  }

  /// Frame `index`, below the count: Ok or Bad, or End where the recording holds less than it
  /// promised.
  virtual ReadResult read(std::size_t index) = 0;

  static ReadResult end() { return {}; }
  static ReadResult ok(FramePtr frame) { return {ReadResult::Status::Ok, std::move(frame), {}, 0}; }
  static ReadResult bad(std::string message) {
    return {ReadResult::Status::Bad, nullptr, std::move(message), 0};
  }

 private:
  SourceInfo m_info;
  std::size_t m_next = 0;
};

}  // namespace boomwatch
