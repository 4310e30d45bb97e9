#pragma once

#include <string>
#include <string_view>

#include "parameters/parameter_table.h"

namespace boomwatch {

/// The row of a key. Throws Error that names an unknown key, and the most similar known one.
const ParameterInfo& findParameter(std::string_view key);

/// A value as presets and the command line spell it: "0.04", "off", "exact", "true".
std::string formatValue(const ParameterInfo& info, const ParameterValue& value);

/// Reads such a text. Throws Error with key, value and range. Rejects NaN, infinities and trailing
/// text.
ParameterValue parseValue(const ParameterInfo& info, std::string_view text);

/// Sets one parameter from text. Throws like findParameter and parseValue.
void setParameter(Parameters& parameters, std::string_view key, std::string_view text);

/// The allowed values: "0.001 to 1 m", "off or 0 to 100 m", "exact, rays", "true, false".
std::string rangeText(const ParameterInfo& info);

}  // namespace boomwatch
