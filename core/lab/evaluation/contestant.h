#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tracking/tracker.h"

namespace boomwatch {

/// A tracker that takes part in an evaluation.
struct Contestant {
  std::string name;           ///< on the command line and in tables
  bool hasConfidence = true;  ///< whether it says how sure it is
  std::function<std::unique_ptr<Tracker>()> make;
};

/// Ours (tld, cmt, klt, csrt) and, beside them, OpenCV's own TLD, CSRT and MedianFlow. Our csrt and
/// opencv_csrt are the same engine; ours adds a confidence and admits that it lost the target.
std::vector<Contestant> contestants();

/// Those of contestants() that are named, in the order of names; all where none is. Throws Error
/// that lists the names when one is unknown.
std::vector<Contestant> contestantsNamed(std::span<const std::string> names);

}  // namespace boomwatch
