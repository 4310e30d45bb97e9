#pragma once

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace boomwatch {

/// ASCII alone, whatever the locale.
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// In small letters; letters outside ASCII stay.
inline std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

/// With its dot: ".png" of "A.PNG".
inline std::string lowerExtension(const std::filesystem::path& file) {
  return lower(file.extension().string());
}

/// The words of a line, parted by blanks; a carriage return counts as one.
inline std::vector<std::string_view> words(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  std::vector<std::string_view> result;
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    result.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return result;
}

/// The whole of `text` as a number; absent when it is anything else or does not fit. Independent of
/// the locale, which a window toolkit may have set to one with a decimal comma.
template <class T>
std::optional<T> toNumber(std::string_view text) {
  T value{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Walks through text line by line and counts.
class LineReader {
 public:
  explicit LineReader(std::string_view text, std::size_t lineNumber = 0)
      : m_text(text), m_lineNumber(lineNumber) {}

  /// Without its line feed; absent at the end.
  std::optional<std::string_view> next() {
    if (m_position >= m_text.size()) return std::nullopt;
    const std::size_t end = std::min(m_text.find('\n', m_position), m_text.size());
    const std::string_view line = m_text.substr(m_position, end - m_position);
    m_position = end + 1;
    ++m_lineNumber;
    return line;
  }
  /// Of the line given last, from 1.
  std::size_t lineNumber() const { return m_lineNumber; }
  /// What follows the line given last.
  std::string_view rest() const { return m_text.substr(std::min(m_position, m_text.size())); }

 private:
  std::string_view m_text;
  std::size_t m_position = 0;
  std::size_t m_lineNumber;
};

}  // namespace boomwatch
