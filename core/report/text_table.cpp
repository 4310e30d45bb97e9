#include "report/text_table.h"

#include <array>
#include <charconv>

namespace boomwatch {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result.append(c == '"' ? 2 : 1, c);
  result += '"';
  return result;
}

}  // namespace

std::string fixedText(std::optional<double> value, int decimals, double factor) {
  if (!value) return "";
  std::array<char, 400> buffer{};  // the largest double has 309 digits
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), *value * factor,
                                 std::chars_format::fixed, decimals);
  return {buffer.data(), end.ptr};
}

std::string csvLine(std::span<const std::string> cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += quoted(cells[i]);
    line += i + 1 < cells.size() ? ',' : '\n';
  }
  return line;
}

std::string markdownLine(std::span<const std::string> cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char c : cell.empty() ? std::string("-") : cell) {
      if (c == '|') line += '\\';
      line += c;
    }
    line += " |";
  }
  line += '\n';
  return line;
}

std::string markdownRule(std::size_t columns, std::size_t texts) {
  std::string line = "|";
  for (std::size_t i = 0; i < columns; ++i) line += i < texts ? "---|" : "--:|";
  line += '\n';
  return line;
}

}  // namespace boomwatch
