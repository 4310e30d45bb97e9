#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace boomwatch {

/// Walks through little-endian bytes. A step past the end fails, and so does every one after it:
/// numbers are then 0 and texts empty. Owns nothing.
class ByteCursor {
 public:
  explicit ByteCursor(std::string_view bytes) : m_bytes(bytes) {}

  template <class T>
  T number() {
    T value{};
    const std::string_view taken = take(sizeof(T));
    if (!taken.empty()) std::memcpy(&value, taken.data(), sizeof(T));
    return value;
  }
  /// The next `count` bytes; empty when there are fewer.
  std::string_view take(std::uint64_t count) {
    if (m_failed || count > m_bytes.size() - m_position) {
      m_failed = true;
      return {};
    }
    const std::string_view taken = m_bytes.substr(m_position, static_cast<std::size_t>(count));
    m_position += static_cast<std::size_t>(count);
    return taken;
  }
  /// Bytes with their number, 32 bits, before them.
  std::string_view counted() { return take(number<std::uint32_t>()); }

  bool failed() const { return m_failed; }
  bool atEnd() const { return m_failed || m_position == m_bytes.size(); }
  std::size_t position() const { return m_position; }
  std::size_t remaining() const { return m_failed ? 0 : m_bytes.size() - m_position; }

 private:
  std::string_view m_bytes;
  std::size_t m_position = 0;
  bool m_failed = false;
};

}  // namespace boomwatch
