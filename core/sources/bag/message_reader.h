#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "sources/bag/bag_file.h"

namespace boomwatch {

/// Reads the fields of a ROS message one after the other, in ROS 1's serialisation or in ROS 2's
/// (CDR, little-endian). Past the end it fails once and for all: numbers are then 0, texts empty.
class MessageReader {
 public:
  MessageReader(std::string_view bytes, BagEncoding encoding)
      : m_bytes(bytes), m_isCdr(encoding == BagEncoding::Cdr) {
    if (!m_isCdr) return;
    // Four bytes say how the rest is encoded; offsets count from behind them.
    const bool isLittleEndian = bytes.size() >= 4 && bytes[0] == 0 && bytes[1] == 1;
    m_failed = !isLittleEndian;
    m_bytes.remove_prefix(std::min<std::size_t>(4, bytes.size()));
  }

  template <class T>
  T number() {
    align(sizeof(T));
    T value{};
    const std::string_view taken = take(sizeof(T));
    if (!taken.empty()) std::memcpy(&value, taken.data(), sizeof(T));
    return value;
  }
  std::string text() {
    std::string_view taken = take(number<std::uint32_t>());
    if (m_isCdr && !taken.empty()) taken.remove_suffix(1);  // it ends with a zero
    return std::string(taken);
  }
  /// Bytes with their number before them.
  std::string_view bytes() { return take(number<std::uint32_t>()); }
  /// `count` numbers, or as many as the number before them says.
  std::vector<double> doubles(std::uint32_t count) {
    std::vector<double> values;
    if (count > 0) align(sizeof(double));
    if (std::uint64_t(count) * sizeof(double) > m_bytes.size() - m_position) m_failed = true;
    while (!m_failed && values.size() < count) values.push_back(number<double>());
    return values;
  }
  std::vector<double> doubles() { return doubles(number<std::uint32_t>()); }

  /// std_msgs/Header. Gives its stamp, nanoseconds.
  std::int64_t header() {
    if (!m_isCdr) number<std::uint32_t>();  // seq
    const std::int64_t seconds =
        m_isCdr ? std::int64_t(number<std::int32_t>()) : std::int64_t(number<std::uint32_t>());
    const auto nanoseconds = number<std::uint32_t>();
    text();  // frame_id
    return seconds * 1'000'000'000 + nanoseconds;
  }

  bool failed() const { return m_failed; }

 private:
  void align(std::size_t size) {
    if (m_isCdr) take((size - m_position % size) % size);
  }
  std::string_view take(std::uint64_t count) {
    if (m_failed || count > m_bytes.size() - m_position) {
      m_failed = true;
      return {};
    }
    const std::string_view taken = m_bytes.substr(m_position, static_cast<std::size_t>(count));
    m_position += static_cast<std::size_t>(count);
    return taken;
  }

  std::string_view m_bytes;
  std::size_t m_position = 0;
  bool m_isCdr;
  bool m_failed = false;
};

}  // namespace boomwatch
