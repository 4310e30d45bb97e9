#include "pipeline/warning_level.h"

#include <utility>

namespace boomwatch {
namespace {

int urgency(WarningLevel level) {
  switch (level) {
    case WarningLevel::Clear:
      return 0;
    case WarningLevel::NoDistance:
      return 1;
    case WarningLevel::Caution:
      return 2;
    case WarningLevel::Warning:
      return 3;
    case WarningLevel::Collision:
      return 4;
  }
  return 4;
}

}  // namespace

std::string_view toString(WarningLevel level) {
  switch (level) {
    case WarningLevel::Clear:
      return "clear";
    case WarningLevel::Caution:
      return "caution";
    case WarningLevel::Warning:
      return "warning";
    case WarningLevel::Collision:
      return "collision";
    case WarningLevel::NoDistance:
      return "no_distance";
  }
  return "";
}

WarningLevel warningLevel(const Clearance& clearance, const WarningParameters& parameters) {
  if (clearance.state == ClearanceState::Unknown) return WarningLevel::NoDistance;
  if (!clearance.nearest) return WarningLevel::Clear;
  const double distance = clearance.nearest->distance;
  if (distance <= 0.0) return WarningLevel::Collision;
  if (distance <= parameters.warningDistance) return WarningLevel::Warning;
  if (distance <= parameters.cautionDistance) return WarningLevel::Caution;
  return WarningLevel::Clear;
}

void WarningLatch::note(WarningLevel level) {
  if (urgency(level) > urgency(m_worst)) m_worst = level;
}

WarningLevel WarningLatch::take() { return std::exchange(m_worst, WarningLevel::Clear); }

}  // namespace boomwatch
