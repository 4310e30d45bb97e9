#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "frame/frame.h"

namespace boomwatch {

/// What a source is, fixed while it is open.
struct SourceInfo {
  std::string address;                    ///< as given to openSource
  std::optional<std::size_t> frameCount;  ///< absent when it has no end (live)
  double nominalRate = 0.0;               ///< frames a second; 0 if it has none of its own
  bool live = false;                      ///< cannot seek or wait; frames may be lost
  /// English: what a person should know of the recording that is no fault; empty if nothing.
  std::string note = {};
};

/// The outcome of one read. Faults of single frames are values: the source goes on after them.
struct ReadResult {
  enum class Status {
    Ok,       ///< `frame` is set
    End,      ///< a recording is over
    Stalled,  ///< a live source gave nothing within the time allowed
    Bad,      ///< this frame could not be read; `message` says why; the next read goes on
    Lost,     ///< a live source is gone; `message` says why; reopen it
  };
  Status status = Status::End;
  FramePtr frame;
  std::string message;
  /// Live: frames that came and went unread since the last read.
  std::size_t dropped = 0;
};

/// Where frames come from. Used by one thread, the worker's; never the GUI's.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual SourceInfo info() const = 0;
  /// The next frame. Recordings ignore `patience`; a live source returns Stalled after it.
  virtual ReadResult next(std::chrono::milliseconds patience) = 0;
  /// The next read gives frame `index`. False when live or out of range; nothing changes then.
  virtual bool seek(std::size_t index) = 0;
};

/// What a source may need to know besides its address.
struct SourceOptions {
  std::string calibration;  ///< file, when it does not lie beside the recording
};

}  // namespace boomwatch
