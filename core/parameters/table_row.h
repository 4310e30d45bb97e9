#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "parameters/parameter_range.h"
#include "parameters/parameter_table.h"

/// Building blocks and checks of the parameter table. Compile time only.
namespace boomwatch::table_row {

using Names = std::span<const std::string_view>;

struct Range {
  double minimum = 0.0;
  double maximum = 1.0;
  double step = 1.0;
};

struct Text {
  const char* group;
  const char* label;
  const char* tooltip;
  const char* unit = "";
};

template <auto Group, auto Field>
constexpr auto& access(auto& parameters) {
  return (parameters.*Group).*Field;
}

/// Makes the row of one field of one group of Parameters.
template <auto Group, auto Field>
constexpr ParameterInfo row(std::string_view key, Text text, Range range = {}, Names names = {}) {
  using T = std::remove_cvref_t<decltype(access<Group, Field>(std::declval<Parameters&>()))>;
  auto get = [](const Parameters& p) -> ParameterValue {
    const T& value = access<Group, Field>(p);
    if constexpr (std::is_enum_v<T>) {
      return Choice{static_cast<int>(value)};
    } else {
      return value;
    }
  };
  auto set = [](Parameters& p, const ParameterValue& value) {
    if constexpr (std::is_enum_v<T>) {
      access<Group, Field>(p) = static_cast<T>(std::get<Choice>(value).index);
    } else {
      access<Group, Field>(p) = std::get<T>(value);
    }
  };
  return {key,           text.group, text.label, text.tooltip, text.unit, range.minimum,
          range.maximum, range.step, names,      get,          set};
}

/// Converts to any leaf type of Parameters, so that leafCount() can count the leaves.
struct AnyLeaf {
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) constexpr operator T() const {
    return T{};
  }  // NOLINT: implicit on purpose
};
template <class T, class... Leaves>
consteval std::size_t leafCount() {
  if constexpr (requires { T{Leaves{}..., AnyLeaf{}}; }) {
    return leafCount<T, Leaves..., AnyLeaf>();
  } else {
    return sizeof...(Leaves);
  }
}
consteval bool keysUnique(std::span<const ParameterInfo> table) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (table[i].key == table[j].key) return false;
    }
  }
  return true;
}
consteval bool defaultsInRange(std::span<const ParameterInfo> table) {
  const Parameters defaults;
  return std::all_of(table.begin(), table.end(),
                     [&](const auto& info) { return inRange(info, info.get(defaults)); });
}

}  // namespace boomwatch::table_row
