#include "simulation/yard/clutter.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "simulation/yard/dice.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr double turnOf = 2.0 * std::numbers::pi;
constexpr int birds = 4, leaves = 36;

/// Which round of `period` seconds it is, and how much of it is over, 0..1.
std::pair<int, double> roundOf(double time, double period) {
  const double rounds = time / period;
  return {static_cast<int>(std::floor(rounds)), rounds - std::floor(rounds)};
}

void addBird(Parts& parts, std::uint64_t seed, int index, double time) {
  Dice own(seed, 100 + static_cast<std::uint64_t>(index));
  const double period = own.uniform(7.0, 12.0);
  const auto [round, share] = roundOf(time + own.uniform(0.0, period), period);
  Dice dice(seed,
            1000 + 64 * static_cast<std::uint64_t>(round) + static_cast<std::uint64_t>(index));
  const double side = dice.below(2) == 0 ? 1.0 : -1.0;
  const double z = dice.uniform(5.0, 12.0);
  const double y = dice.uniform(-0.6, 1.2) + 0.3 * std::sin(turnOf * share * 2.0);
  const Vector3d place(side * (share - 0.5) * 26.0, y, z + 2.0 * (share - 0.5));
  const Eigen::Matrix3d heading =
      rotationFromYawPitchRoll(side > 0 ? std::numbers::pi / 2 : -std::numbers::pi / 2, 0.0, 0.0);
  const auto bird = [&](const Part& part) {
    parts.push_back(withLook(part, YardKind::Bird, Material::Feather, index));
  };
  bird(ellipsoid(place, {0.10, 0.10, 0.34}, heading));
  const double flap = 0.7 * std::sin(turnOf * time * 3.1 + index);
  for (const double wing : {-1.0, 1.0}) {
    const Vector3d out = heading * Vector3d(wing * std::cos(flap), -std::sin(flap), 0.0);
    Eigen::Matrix3d spread;
    spread << out, out.cross(heading.col(2)), heading.col(2);
    bird(ellipsoid(place + 0.2 * out, {0.42, 0.03, 0.15}, spread));
  }
}

void addLeaf(Parts& parts, std::uint64_t seed, int index, double time) {
  Dice own(seed, 200 + static_cast<std::uint64_t>(index));
  const double period = own.uniform(4.0, 8.0);
  const auto [round, share] = roundOf(time + own.uniform(0.0, period), period);
  Dice dice(seed,
            5000 + 64 * static_cast<std::uint64_t>(round) + static_cast<std::uint64_t>(index));
  const double z = dice.uniform(2.5, 10.0);
  const double phase = dice.uniform(0.0, turnOf);
  const Vector3d place(
      dice.uniform(-0.65, 0.65) * z + 0.35 * std::sin(turnOf * share * 3.0 + phase),
      -1.8 + 5.1 * share, z + 0.25 * std::cos(turnOf * share * 2.0 + phase));
  const Eigen::Matrix3d tumble = rotationFromYawPitchRoll(
      phase + turnOf * share * 2.0, phase + turnOf * share * 3.0, turnOf * share * 1.5);
  parts.push_back(withLook(ellipsoid(place, {0.09, 0.008, 0.065}, tumble), YardKind::Leaf,
                           Material::FallenLeaf, index));
}

}  // namespace

Parts clutterAt(std::uint64_t seed, double time) {
  Parts parts;
  for (int k = 0; k < birds; ++k) addBird(parts, seed, k, time);
  for (int k = 0; k < leaves; ++k) addLeaf(parts, seed, k, time);
  return parts;
}

}  // namespace boomwatch
