#include "crane/crane_memory.h"

#include <algorithm>
#include <cmath>

namespace boomwatch {
namespace {

constexpr double tick = 1e-6;  // seconds; absorbs rounding of the stamps

/// 21 bits a coordinate, enough for 125 km on either side.
std::int64_t placeOf(const Eigen::Vector3f& p) {
  constexpr std::int64_t bits = 21, mask = (std::int64_t{1} << bits) - 1;
  std::int64_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double at = std::floor(static_cast<double>(p[axis]) / CraneMemory::cell);
    place = (place << bits) | (static_cast<std::int64_t>(at) & mask);
  }
  return place;
}

}  // namespace

void CraneMemory::note(double stamp, const Points& crane) {
  if (crane.empty()) return;
  Moment moment{stamp, {}, {}};
  for (const Eigen::Vector3f& p : crane) {
    moment.box.extend(p);
    moment.places.insert(placeOf(p));
  }
  m_moments.push_back(std::move(moment));
}

void CraneMemory::forgetBefore(double stamp) {
  std::erase_if(m_moments, [&](const Moment& moment) {
    return moment.stamp < stamp - lasting - tick || moment.stamp > stamp;
  });
}

bool CraneMemory::knows(const Eigen::Vector3f& p) const {
  return std::ranges::any_of(m_moments, [&](const Moment& moment) {
    return moment.box.contains(p) && moment.places.contains(placeOf(p));
  });
}

}  // namespace boomwatch
