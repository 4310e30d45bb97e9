#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "frame/clearance.h"
#include "frame/oriented_box.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// What can come too near to something.
enum class WatchedObject { Load, Tool, Boom };
/// Stable name for files and logs.
std::string_view nameOf(WatchedObject object);

/// How far one of them is from what is around it.
struct Watched {
  WatchedObject object = WatchedObject::Load;
  int segment = 0;                 ///< of the boom, 1 is the one at the tool; else 0
  std::optional<OrientedBox> box;  ///< camera frame, metres; absent where it is not seen
  Clearance clearance;
};

/// Index of the one whose clearance is that of the whole: the smallest distance leads. What is
/// watched first, the load unless it is not watched, must be known for that: otherwise its
/// "unknown" leads, unless another one is within the warning distance. `watched` must not be empty.
std::size_t leadingOf(const std::vector<Watched>& watched, const WarningParameters& parameters);

}  // namespace boomwatch
