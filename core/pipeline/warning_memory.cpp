#include "pipeline/warning_memory.h"

#include <algorithm>

namespace boomwatch {
namespace {

/// Slower than this it stands still. m/s
constexpr double retreatSpeed = 0.05;

WarningLevel levelByTime(const std::optional<Approach>& approach,
                         const WarningParameters& parameters) {
  if (!approach || !approach->timeToContact) return WarningLevel::Clear;
  if (*approach->timeToContact <= parameters.warningTime) return WarningLevel::Warning;
  if (*approach->timeToContact <= parameters.cautionTime) return WarningLevel::Caution;
  return WarningLevel::Clear;
}

/// The level if everything were nearer by `margin` metres.
WarningLevel levelWithin(double margin, const WarningInput& input,
                         const WarningParameters& parameters) {
  Clearance nearer = input.clearance;
  if (nearer.nearest) nearer.nearest->distance -= margin;
  return std::max(warningLevel(nearer, parameters), levelByTime(input.approach, parameters));
}

}  // namespace

WarningMemory nextWarning(const WarningMemory& memory, const WarningInput& input,
                          const WarningParameters& parameters) {
  if (input.clearance.state == ClearanceState::Unknown) return {};
  const WarningLevel wanted = levelWithin(0.0, input, parameters);
  if (memory.level == WarningLevel::NoDistance || wanted >= memory.level) return {wanted, {}};

  const WarningLevel kept =
      std::min(memory.level, levelWithin(parameters.deadband, input, parameters));
  if (kept == memory.level) return {kept, {}};
  const bool retreats = input.approach && input.approach->closingSpeed &&
                        *input.approach->closingSpeed < -retreatSpeed;
  // A clock that was set back begins the delay anew.
  const double since = std::min(memory.lowerSince.value_or(input.stamp), input.stamp);
  if (retreats || input.stamp - since >= parameters.releaseDelay) return {kept, {}};
  return {memory.level, since};
}

}  // namespace boomwatch
