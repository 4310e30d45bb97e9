#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace boomwatch {

/// What JSON holds of bytes (RFC 4648). Signs that are none of the alphabet are skipped.
inline std::string bytesOfBase64(std::string_view text) {
  static constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  static const std::array<std::int8_t, 256> values = [] {
    std::array<std::int8_t, 256> table{};
    table.fill(-1);
    for (std::size_t k = 0; k < alphabet.size(); ++k) {
      table[static_cast<unsigned char>(alphabet[k])] = static_cast<std::int8_t>(k);
    }
    return table;
  }();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::int8_t value = values[static_cast<unsigned char>(c)];
    if (value < 0) continue;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  return bytes;
}

}  // namespace boomwatch
