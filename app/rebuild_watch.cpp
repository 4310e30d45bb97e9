#include "rebuild_watch.h"

namespace boomwatch {
namespace {

GridGeometry geometryOf(const Parameters& parameters) {
  return {parameters.bounds, parameters.model.resolution};
}

}  // namespace

void RebuildWatch::want(const Parameters& parameters) { m_wanted = geometryOf(parameters); }

void RebuildWatch::show(const Result& result, TimePoint now) {
  m_shown = geometryOf(result.parameters);
  if (!m_wanted) m_wanted = m_shown;
  if (result.modelRebuilt) m_rebuilt = now;
}

bool RebuildWatch::rebuilding(TimePoint now) const {
  constexpr std::chrono::seconds readable(1);
  if (m_wanted && m_shown && !(*m_wanted == *m_shown)) return true;
  return m_rebuilt && now - *m_rebuilt < readable;
}

}  // namespace boomwatch
