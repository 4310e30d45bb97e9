#include "collision/search_target.h"

#include <algorithm>

namespace boomwatch {

using Eigen::Vector3d;

Vector3d SearchTarget::nearestOnLine(const Vector3d& a, const Vector3d& b) const {
  const Vector3d start = m_toBox * (a - m_centre);
  const Vector3d along = m_toBox * (b - a);
  // Half the derivative of the squared distance: continuous, never falling, straight between the
  // places where the line crosses a plane of the box's faces.
  const auto slopeAt = [&](double t) {
    double slope = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double at = start[k] + t * along[k];
      slope += (at - std::clamp(at, -m_half[k], m_half[k])) * along[k];
    }
    return slope;
  };
  // The minimum lies between the last of these places where it still falls and the first where it
  // does not.
  double falling = 0.0, rising = 1.0;
  double fall = slopeAt(0.0), rise = slopeAt(1.0);
  if (fall >= 0.0) return a;
  if (rise <= 0.0) return b;
  for (int k = 0; k < 3; ++k) {
    if (along[k] == 0.0) continue;
    for (const double side : {-m_half[k], m_half[k]}) {
      const double t = (side - start[k]) / along[k];
      if (!(t > falling && t < rising)) continue;
      const double slope = slopeAt(t);
      (slope < 0.0 ? falling : rising) = t;
      (slope < 0.0 ? fall : rise) = slope;
    }
  }
  const double t = falling + (rising - falling) * (-fall / (rise - fall));
  return a + t * (b - a);
}

}  // namespace boomwatch
