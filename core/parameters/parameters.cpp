#include "parameters/parameters.h"

namespace boomwatch {

double searchReach(const Parameters& p) {
  return p.clearance.method == ClearanceMethod::Rays ? p.clearance.radius * p.model.resolution
                                                     : p.clearance.range;
}

bool searchIsShort(const Parameters& p) {
  return searchReach(p) < p.warning.cautionDistance * (1.0 - 1e-9);
}

}  // namespace boomwatch
