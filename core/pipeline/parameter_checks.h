#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parameters/parameters.h"

namespace boomwatch {

/// Remarks about values that are valid but have an unexpected effect.
enum class ParameterRemark {
  NothingEnters,   ///< probtresh is not below the maximum probability of a cell
  NothingLeaves,   ///< a cell stays occupied even when the camera sees through it
  SearchTooShort,  ///< without an obstacle in reach there is no distance, instead of clear
};
struct ParameterWarning {
  ParameterRemark remark = ParameterRemark::NothingEnters;
  std::string_view key;
  std::string message;  ///< English; the window has its own text for each remark
};

/// Throws Error naming the keys when values contradict each other (min >= max, a model larger than
/// memory_limit, an even block size, ...). Single ranges are checked where a value is set.
void validate(const Parameters& parameters);

/// One warning for each remark that applies to `parameters`. Pure.
std::vector<ParameterWarning> warningsFor(const Parameters& parameters);

}  // namespace boomwatch
