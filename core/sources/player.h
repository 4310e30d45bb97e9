#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>

#include "sources/frame_source.h"

namespace boomwatch {

enum class PlayState { Playing, Paused, Ended, Lost };

/// What a player is doing, for whoever shows it.
struct PlayerStatus {
  PlayState state = PlayState::Paused;
  std::optional<std::size_t> position;  ///< index of the frame delivered last
  std::optional<std::size_t> count;     ///< absent: no end
  bool live = false;
  bool loop = false;
  double speed = 1.0;
  bool operator==(const PlayerStatus&) const = default;
};

/// Decides when the next frame of a source is due: play, pause, step, seek, loop and speed.
///
/// It never looks at a clock: the caller says what time it is, so that it can be tested without
/// waiting. A recording is paced by its stamps (by its nominal rate where they do not grow), every
/// frame of it is delivered, and one frame is read ahead, so that reading costs no delay. A live
/// source is always due while it plays. Used by one thread, the one that uses the source.
class Player {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr double slowest = 0.1;
  static constexpr double fastest = 10.0;
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  /// Begins paused, before the first frame.
  explicit Player(std::unique_ptr<FrameSource> source);

  /// From the start again when the recording had ended.
  void play();
  void pause();
  /// One frame on (1) or back (-1), then paused. Back only where the source can seek.
  void step(int direction);
  /// The next frame delivered is `index`, at once, even while paused. False: nothing changes.
  bool seek(std::size_t index);
  void setLoop(bool loop) { m_loop = loop; }
  /// Times real time, held within slowest..fastest; `unlimited`: as fast as frames can be used.
  void setSpeed(double speed);

  /// What there is to process at `now`; absent while nothing is due. Ok, Bad, Stalled as the
  /// source said; End and Lost once, when the state changes to Ended or Lost.
  std::optional<ReadResult> poll(TimePoint now, std::chrono::milliseconds patience);

  /// When poll will next have work; a time in the past: at once; absent: not before a command.
  std::optional<TimePoint> due() const;

  PlayState state() const { return m_state; }
  const SourceInfo& info() const { return m_info; }
  PlayerStatus status() const {
    return {m_state, m_position, m_info.frameCount, m_info.live, m_loop, m_speed};
  }

 private:
  ReadResult readRecording();
  void note(const ReadResult& read);
  double gapBefore(const ReadResult& read) const;
  /// Absent: at once.
  std::optional<TimePoint> dueTime(const ReadResult& read) const;
  ReadResult deliver(TimePoint now);

  std::unique_ptr<FrameSource> m_source;
  SourceInfo m_info;
  PlayState m_state = PlayState::Paused;
  bool m_loop = false;
  double m_speed = 1.0;
  bool m_single = false;  ///< one frame is wanted at once, whatever the clock says
  std::size_t m_next = 0;
  std::optional<std::size_t> m_position;
  std::optional<double> m_stamp;         ///< of the frame delivered last, seconds
  std::optional<TimePoint> m_delivered;  ///< when it was due
  std::optional<ReadResult> m_ahead;     ///< recordings: read, not yet due
};

}  // namespace boomwatch
