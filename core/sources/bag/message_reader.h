#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sources/bag/bag_file.h"
#include "sources/bag/byte_cursor.h"

namespace boomwatch {

/// What std_msgs/Header says.
struct MessageHeader {
  std::int64_t stamp = 0;  ///< nanoseconds; 0 where nobody set it
  std::string frame;       ///< of the coordinates, "camera_left_optical_frame"
};

/// Reads the fields of a ROS message one after the other, in ROS 1's serialisation or in ROS 2's
/// (CDR, little-endian). Past the end it fails once and for all: numbers are then 0, texts empty.
class MessageReader {
 public:
  MessageReader(std::string_view bytes, BagEncoding encoding)
      : m_cursor(bytes), m_isCdr(encoding == BagEncoding::Cdr) {
    if (!m_isCdr) return;
    // Four bytes say how the rest is encoded; offsets count from behind them.
    constexpr std::string_view littleEndian("\0\1", 2);
    m_isOther = m_cursor.take(4).substr(0, 2) != littleEndian;
  }

  template <class T>
  T number() {
    align(sizeof(T));
    return m_cursor.number<T>();
  }
  std::string text() {
    std::string_view taken = bytes();
    if (m_isCdr && !taken.empty()) taken.remove_suffix(1);  // it ends with a zero
    return std::string(taken);
  }
  /// Bytes with their number before them.
  std::string_view bytes() { return m_cursor.take(number<std::uint32_t>()); }
  /// `count` numbers.
  std::vector<double> doubles(std::uint32_t count) {
    std::vector<double> values;
    if (count > m_cursor.remaining() / sizeof(double)) m_cursor.take(UINT64_MAX);  // fails
    while (!failed() && values.size() < count) values.push_back(number<double>());
    return values;
  }
  /// As many numbers as the one before them says.
  std::vector<double> doubles() { return doubles(number<std::uint32_t>()); }

  MessageHeader header() {
    if (!m_isCdr) number<std::uint32_t>();  // seq
    const auto seconds = number<std::uint32_t>();
    const auto nanoseconds = number<std::uint32_t>();
    return {std::int64_t(seconds) * 1'000'000'000 + nanoseconds, text()};
  }

  bool failed() const { return m_isOther || m_cursor.failed(); }

 private:
  void align(std::size_t size) {
    constexpr std::size_t encoding = 4;
    if (m_isCdr) m_cursor.take((size - (m_cursor.position() - encoding) % size) % size);
  }

  ByteCursor m_cursor;
  bool m_isCdr;
  bool m_isOther = false;  ///< CDR of another kind, such as big-endian
};

}  // namespace boomwatch
