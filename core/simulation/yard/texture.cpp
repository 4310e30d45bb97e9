#include "simulation/yard/texture.h"

#include <algorithm>
#include <array>

#include "simulation/yard/dice.h"

namespace boomwatch {
namespace {

constexpr int side = 64, mask = side - 1;

class Lattice {
 public:
  Lattice() {
    Dice dice(20);
    for (float& value : m_values) value = static_cast<float>(dice.uniform(-1.0, 1.0));
  }
  float at(int x, int y, int z) const {
    return m_values[static_cast<std::size_t>(((z & mask) * side + (y & mask)) * side + (x & mask))];
  }

 private:
  std::array<float, std::size_t{side} * side * side> m_values{};
};

const Lattice& lattice() {
  static const Lattice it;
  return it;
}

/// std::floor is a call into the library in a build for any x86-64, and this is asked for millions
/// of times a picture.
int below(float x) {
  const int whole = static_cast<int>(x);
  return whole - (static_cast<float>(whole) > x ? 1 : 0);
}

float eased(float t) { return t * t * (3.0F - 2.0F * t); }
float mix(float a, float b, float t) { return a + t * (b - a); }

}  // namespace

float noiseAt(const Eigen::Vector3f& p) {
  const Lattice& values = lattice();
  const int x = below(p.x()), y = below(p.y()), z = below(p.z());
  const float s = eased(p.x() - static_cast<float>(x)), t = eased(p.y() - static_cast<float>(y)),
              r = eased(p.z() - static_cast<float>(z));
  const auto plane = [&](int k) {
    return mix(mix(values.at(x, y, k), values.at(x + 1, y, k), s),
               mix(values.at(x, y + 1, k), values.at(x + 1, y + 1, k), s), t);
  };
  return mix(plane(z), plane(z + 1), r);
}

float roughness(const Eigen::Vector3f& p, float coarsest, int octaves, float footprint) {
  float sum = 0.0F, size = coarsest, weight = 0.62F;
  for (int k = 0; k < octaves; ++k, size *= 0.5F, weight *= 0.8F) {
    // Gone where a feature is as small as a pixel, whole from three pixels on.
    const float seen = std::min(1.0F, 0.5F * (size / footprint - 1.0F));
    if (seen <= 0.0F) break;
    const Eigen::Vector3f shift = Eigen::Vector3f::Constant(7.3F * static_cast<float>(k));
    sum += seen * weight * noiseAt(p / size + shift);
  }
  return sum;
}

}  // namespace boomwatch
