#include "pipeline/watched.h"

#include <algorithm>
#include <limits>

namespace boomwatch {

std::string_view nameOf(WatchedObject object) {
  switch (object) {
    case WatchedObject::Load:
      return "load";
    case WatchedObject::Tool:
      return "tool";
    case WatchedObject::Boom:
      return "boom";
  }
  return "";
}

std::size_t leadingOf(const std::vector<Watched>& watched, const WarningParameters& parameters) {
  const auto distance = [](const Watched& one) {
    return one.clearance.nearest ? one.clearance.nearest->distance
                                 : std::numeric_limits<double>::infinity();
  };
  const auto nearest = std::min_element(
      watched.begin(), watched.end(),
      [&](const Watched& a, const Watched& b) { return distance(a) < distance(b); });
  const double least = distance(*nearest);
  const bool known = watched.front().clearance.state != ClearanceState::Unknown;
  const double limit = known ? std::numeric_limits<double>::max() : parameters.warningDistance;
  return least <= limit ? static_cast<std::size_t>(nearest - watched.begin()) : 0;
}

}  // namespace boomwatch
