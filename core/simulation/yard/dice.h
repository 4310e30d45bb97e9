#pragma once

#include <cstdint>

namespace boomwatch {

/// Mixes the bits of a number (the finaliser of MurmurHash3).
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
  x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

/// Random numbers that are the same on every machine: the standard's distributions need not be.
class Dice {
 public:
  /// Another `stream` of the same seed is independent of the first.
  explicit Dice(std::uint64_t seed, std::uint64_t stream = 0)
      : m_state(mixed(mixed(seed + 1) ^ (stream * 0x9e3779b97f4a7c15ULL))) {}

  std::uint64_t bits() { return mixed(m_state += 0x9e3779b97f4a7c15ULL); }
  /// Uniformly distributed from a up to, not including, b.
  double uniform(double a, double b) {
    return a + (b - a) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
  /// From 0 up to, not including, `count`, which is above 0.
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }

 private:
  std::uint64_t m_state;
};

}  // namespace boomwatch
