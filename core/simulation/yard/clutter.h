#pragma once

#include "simulation/yard/part.h"

namespace boomwatch {

/// Birds that cross the yard and leaves that fall, at a time. Yard frame. Pure.
Parts clutterAt(std::uint64_t seed, double time);

}  // namespace boomwatch
