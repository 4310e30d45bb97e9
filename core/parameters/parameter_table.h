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

/// One row of the table behind the dock, the command line, --help and the presets.
struct ParameterInfo {
  std::string_view key;
  const char* group;    ///< heading in the dock; translation context "Parameters"
  const char* label;    ///< translation context "Parameters"
  const char* tooltip;  ///< translation context "Parameters"
  const char* unit;     ///< "" without a unit
  double minimum;       ///< numbers only
  double maximum;
  double step;
  std::span<const std::string_view> choices;  ///< names of a Choice, as in presets
  ParameterValue (*get)(const Parameters&);
  void (*set)(Parameters&, const ParameterValue&);  ///< with the same alternative as get()
};

/// All parameters, in display order.
std::span<const ParameterInfo> parameterTable();

}  // namespace boomwatch
