#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "pipeline/parameters.h"

// Lets lupdate find the texts without Qt in the core.
#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(context, text) text
#endif

namespace boomwatch {

/// Index into ParameterInfo::choices.
struct Choice {
  int index = 0;
  constexpr bool operator==(const Choice&) const = default;
};

using ParameterValue = std::variant<bool, int, double, std::optional<double>, Choice>;

/// One row of the table from which the dock, the command line, --help and the presets are made.
struct ParameterInfo {
  std::string_view key;
  const char* group;    ///< heading in the dock; translation context "Parameters"
  const char* label;    ///< translation context "Parameters"
  const char* tooltip;  ///< translation context "Parameters"
  const char* unit;     ///< "" if it has none
  double minimum;       ///< of numbers
  double maximum;
  double step;
  std::span<const std::string_view> choices;  ///< names of a Choice, as presets spell them
  ParameterValue (*get)(const Parameters&);
  void (*set)(Parameters&, const ParameterValue&);  ///< the alternative must be get()'s
};

/// Every parameter there is, in the order a person should see them.
std::span<const ParameterInfo> parameterTable();

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
