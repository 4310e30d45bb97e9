#include "sources/player.h"

#include <algorithm>
#include <utility>

namespace boomwatch {
namespace {

// A gap in the stamps (a recording that was interrupted) is not sat out in full.
constexpr double maxGap = 2.0;
constexpr double rateOfTheUnknown = 10.0;

}  // namespace

Player::Player(std::unique_ptr<FrameSource> source)
    : m_source(std::move(source)), m_info(m_source->info()) {}

void Player::play() {
  if (m_state == PlayState::Lost) return;
  if (m_state == PlayState::Ended && !seek(0)) return;
  m_state = PlayState::Playing;
  m_single = false;
  m_delivered.reset();
}

void Player::pause() {
  if (m_state == PlayState::Playing) m_state = PlayState::Paused;
}

void Player::step(int direction) {
  if (m_state == PlayState::Lost) return;
  if (direction < 0) {
    if (m_position && *m_position > 0) seek(*m_position - 1);
    pause();
    return;
  }
  if (m_state == PlayState::Ended) return;
  m_state = PlayState::Paused;
  m_single = true;
}

bool Player::seek(std::size_t index) {
  if (m_info.live || !m_source->seek(index)) return false;
  m_ahead.reset();
  m_next = index;
  m_stamp.reset();
  m_delivered.reset();
  m_single = true;
  if (m_state == PlayState::Ended) m_state = PlayState::Paused;
  return true;
}

void Player::setSpeed(double speed) {
  m_speed = speed == unlimited ? speed : std::clamp(speed, slowest, fastest);
  m_delivered.reset();
}

std::optional<ReadResult> Player::poll(TimePoint now, std::chrono::milliseconds patience) {
  if (m_state != PlayState::Playing && !m_single) return std::nullopt;
  if (m_info.live) {
    m_ahead = m_source->next(patience);
    return deliver(now);
  }
  if (!m_ahead) m_ahead = readRecording();
  if (const auto at = dueTime(*m_ahead); !m_single && at && *at > now) return std::nullopt;
  return deliver(now);
}

std::optional<Player::TimePoint> Player::due() const {
  if (m_state != PlayState::Playing && !m_single) return std::nullopt;
  const auto at = m_ahead && !m_single ? dueTime(*m_ahead) : std::nullopt;
  return at.value_or(TimePoint::min());
}

ReadResult Player::readRecording() {
  ReadResult read = m_source->next({});
  // An empty recording must not be looped for ever.
  if (read.status == ReadResult::Status::End && m_loop && m_next > 0 && m_source->seek(0)) {
    m_next = 0;
    m_stamp.reset();
    read = m_source->next({});
  }
  return read;
}

double Player::gapBefore(const ReadResult& read) const {
  if (read.frame && m_stamp && read.frame->stamp > *m_stamp) {
    return std::min(read.frame->stamp - *m_stamp, maxGap);
  }
  return 1.0 / (m_info.nominalRate > 0.0 ? m_info.nominalRate : rateOfTheUnknown);
}

std::optional<Player::TimePoint> Player::dueTime(const ReadResult& read) const {
  const bool timed =
      read.status == ReadResult::Status::Ok || read.status == ReadResult::Status::Bad;
  if (!m_delivered || !timed) return std::nullopt;
  const std::chrono::duration<double> gap(gapBefore(read) / m_speed);
  return *m_delivered + std::chrono::duration_cast<TimePoint::duration>(gap);
}

ReadResult Player::deliver(TimePoint now) {
  const auto at = dueTime(*m_ahead);
  // Behind by more than a frame: time goes on from here, rather than in a burst.
  const bool onTime = at && !m_single && now - *at <= *at - *m_delivered;
  m_delivered = onTime ? *at : now;
  ReadResult read = std::move(*m_ahead);
  m_ahead.reset();
  m_single = m_single && read.status == ReadResult::Status::Stalled;
  note(read);
  return read;
}

void Player::note(const ReadResult& read) {
  switch (read.status) {
    case ReadResult::Status::Ok:
      m_position = m_info.live ? m_next : static_cast<std::size_t>(read.frame->sequence);
      m_stamp = read.frame->stamp;
      m_next = *m_position + 1;
      break;
    case ReadResult::Status::Bad:
      m_position = m_next++;
      break;
    case ReadResult::Status::Stalled:
      break;
    case ReadResult::Status::End:
      m_state = PlayState::Ended;
      break;
    case ReadResult::Status::Lost:
      m_state = PlayState::Lost;
      break;
  }
}

}  // namespace boomwatch
