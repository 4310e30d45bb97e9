#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sources/bag/bag_choice.h"
#include "sources/bag/bag_file.h"

namespace boomwatch {

/// The messages of one frame.
struct BagPair {
  std::int64_t stamp = 0;  ///< nanoseconds, of `first`
  BagMessage first;
  std::optional<BagMessage> second;  ///< always set for stereo
};

struct BagPairs {
  std::vector<BagPair> pairs;
  std::size_t unpaired = 0;  ///< pictures of a stereo pair that are left out
};

/// The messages of the chosen topics in order of their stamps, each with the partner nearest in
/// time, at most half a period away. Without a partner a stereo picture is left out, and a depth
/// picture stays alone. Stamps are the headers'; where these are 0, the times of recording.
BagPairs pairMessages(BagFile& bag, const BagChoice& choice);

}  // namespace boomwatch
