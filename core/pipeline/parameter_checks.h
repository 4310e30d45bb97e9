#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parameters/parameters.h"

namespace boomwatch {

/// What there is to say about parameters that are accepted but will not do what they seem to.
enum class ParameterRemark {
  NothingEnters,   ///< probtresh is at or above the highest probability a cell can reach
  NothingLeaves,   ///< so low a threshold that a cell which is looked through stays occupied
  SearchTooShort,  ///< with nothing found there is no distance, rather than clear
};
struct ParameterWarning {
  ParameterRemark remark = ParameterRemark::NothingEnters;
  std::string_view key;
  std::string message;  ///< English; the window has words of its own for each remark
};

/// Throws Error naming the keys when values contradict each other (min >= max, a model larger than
/// memory_limit, an even block size, ...). Single ranges are checked where a value is set.
void validate(const Parameters& parameters);

std::vector<ParameterWarning> warningsFor(const Parameters& parameters);

}  // namespace boomwatch
