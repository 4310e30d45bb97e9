#pragma once

#include "parameters/parameter_table.h"

namespace boomwatch {

/// Whether the range or choices of a row allow `value`. Never true for a NaN.
constexpr bool inRange(const ParameterInfo& info, const ParameterValue& value) {
  auto within = [&](double v) { return v >= info.minimum && v <= info.maximum; };
  if (const auto* d = std::get_if<double>(&value)) return within(*d);
  if (const auto* i = std::get_if<int>(&value)) return within(*i);
  if (const auto* o = std::get_if<std::optional<double>>(&value)) return !*o || within(**o);
  if (const auto* c = std::get_if<Choice>(&value)) {
    return c->index >= 0 && c->index < static_cast<int>(info.choices.size());
  }
  return true;
}

}  // namespace boomwatch
