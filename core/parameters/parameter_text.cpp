#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "files/line_reader.h"
#include "parameters/parameter_range.h"
#include "parameters/parameter_text.h"

namespace boomwatch {
namespace {

/// The shortest text that reads back as the same value; without an exponent where a person would
/// write none ("100000", not "1e+05").
std::string formatNumber(double value) {
  char buffer[32];
  const double size = std::abs(value);
  const bool plain = value == 0.0 || (size >= 1e-6 && size < 1e9);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, format).ptr;
  return {buffer, end};
}

/// What somebody wrote, fit for a message: one line, not too long.
std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string shown(text.substr(0, longest));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return "'" + shown + (text.size() > longest ? "...'" : "'");
}

template <class T>
std::optional<T> number(std::string_view text) {
  const auto value = toNumber<T>(text);
  return value && std::isfinite(static_cast<double>(*value)) ? value : std::nullopt;
}

std::optional<ParameterValue> parse(const ParameterInfo& info, std::string_view text) {
  const ParameterValue kind = info.get(Parameters{});
  if (std::holds_alternative<bool>(kind)) {
    if (text == "true" || text == "on" || text == "1") return true;
    if (text == "false" || text == "off" || text == "0") return false;
    return std::nullopt;
  }
  if (std::holds_alternative<Choice>(kind)) {
    const auto found = std::find(info.choices.begin(), info.choices.end(), text);
    if (found == info.choices.end()) return std::nullopt;
    return Choice{static_cast<int>(found - info.choices.begin())};
  }
  if (std::holds_alternative<int>(kind)) {
    const auto value = number<int>(text);
    return value ? std::optional<ParameterValue>(*value) : std::nullopt;
  }
  const bool optional = std::holds_alternative<std::optional<double>>(kind);
  if (optional && text == "off") return std::optional<double>();
  const auto value = number<double>(text);
  if (!value) return std::nullopt;
  return optional ? ParameterValue(std::optional<double>(*value)) : ParameterValue(*value);
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

const ParameterInfo& findParameter(std::string_view key) {
  const auto table = parameterTable();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const ParameterInfo& info) { return info.key == key; });
  if (found != table.end()) return *found;
  const std::string_view begin = key.substr(0, 100);
  const auto& nearest = *std::min_element(
      table.begin(), table.end(), [&](const ParameterInfo& a, const ParameterInfo& b) {
        return editDistance(a.key, begin) < editDistance(b.key, begin);
      });
  throw Error("parameter " + quoted(key), "there is no such parameter",
              "Did you mean '" + std::string(nearest.key) + "'? --help lists all of them.");
}

std::string formatValue(const ParameterInfo& info, const ParameterValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* i = std::get_if<int>(&value)) return std::to_string(*i);
  if (const auto* d = std::get_if<double>(&value)) return formatNumber(*d);
  if (const auto* o = std::get_if<std::optional<double>>(&value)) {
    return *o ? formatNumber(**o) : "off";
  }
  return std::string(info.choices[static_cast<std::size_t>(std::get<Choice>(value).index)]);
}

std::string rangeText(const ParameterInfo& info) {
  const ParameterValue kind = info.get(Parameters{});
  if (std::holds_alternative<bool>(kind)) return "true, false";
  if (std::holds_alternative<Choice>(kind)) {
    std::string names;
    for (const auto name : info.choices) names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
  }
  const std::string off = std::holds_alternative<std::optional<double>>(kind) ? "off or " : "";
  const std::string unit = *info.unit ? std::string(" ") + info.unit : "";
  return off + formatNumber(info.minimum) + " to " + formatNumber(info.maximum) + unit;
}

ParameterValue parseValue(const ParameterInfo& info, std::string_view text) {
  const auto value = parse(info, text);
  if (value && inRange(info, *value)) return *value;
  throw Error("parameter '" + std::string(info.key) + "'",
              quoted(text) + " is not among " + rangeText(info), "Give a value in that range.");
}

void setParameter(Parameters& parameters, std::string_view key, std::string_view text) {
  const ParameterInfo& info = findParameter(key);
  info.set(parameters, parseValue(info, text));
}

}  // namespace boomwatch
