#pragma once

#include <string>
#include <string_view>

#include "parameters/parameter_table.h"

namespace boomwatch {

/// Throws Error that names the key when there is none such (with the nearest known key).
const ParameterInfo& findParameter(std::string_view key);

/// Text as a preset or a command line spells it: "0.04", "off", "exact", "true".
std::string formatValue(const ParameterInfo& info, const ParameterValue& value);

/// Throws Error that names key, value and range. Never accepts NaN, infinities or trailing text.
ParameterValue parseValue(const ParameterInfo& info, std::string_view text);

/// Sets one parameter from text; throws as findParameter and parseValue do.
void setParameter(Parameters& parameters, std::string_view key, std::string_view text);

/// "0.001 to 1 m", "off or 0 to 100 m", "exact, rays", "true, false".
std::string rangeText(const ParameterInfo& info);

}  // namespace boomwatch
