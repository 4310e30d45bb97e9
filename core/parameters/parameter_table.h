#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "parameters/parameters.h"

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

}  // namespace boomwatch
