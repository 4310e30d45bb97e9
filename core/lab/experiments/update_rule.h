#pragma once

#include <array>

#include "parameters/parameters.h"

namespace boomwatch {

/// An update of the model, and its name as parameters spell it.
struct UpdateRule {
  ModelUpdate update;
  const char* name;
};
/// Those that the experiments compare.
inline constexpr std::array updateRules{UpdateRule{ModelUpdate::Thesis, "thesis"},
                                        UpdateRule{ModelUpdate::Hysteresis, "hysteresis"},
                                        UpdateRule{ModelUpdate::LogOdds, "log_odds"}};

}  // namespace boomwatch
