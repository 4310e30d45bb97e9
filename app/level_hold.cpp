#include "level_hold.h"

namespace boomwatch {
namespace {

WarningLevel worse(WarningLevel a, WarningLevel b) {
  WarningLatch latch;
  latch.note(a);
  latch.note(b);
  return latch.take();
}

}  // namespace

void LevelHold::note(WarningLevel shown, WarningLevel worst, TimePoint now) {
  constexpr std::chrono::seconds visible(2);
  if (m_level && now >= m_until) m_level.reset();
  if (worse(shown, worst) != shown && (!m_level || worse(worst, *m_level) == worst)) {
    m_level = worst;
    m_until = now + visible;
  }
  // Whatever is worse by itself needs no help.
  if (m_level && worse(shown, *m_level) == shown) m_level.reset();
}

std::optional<WarningLevel> LevelHold::held(TimePoint now) const {
  return m_level && now < m_until ? m_level : std::nullopt;
}

}  // namespace boomwatch
