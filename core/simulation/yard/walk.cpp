#include "simulation/yard/walk.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>

namespace boomwatch {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double stride = 1.5;  // metres for two steps

}  // namespace

std::pair<Vector2d, Vector2d> Walk::at(double time) const {
  double round = 0.0;
  const auto side = [&](std::size_t k) -> Vector2d {
    return corners[(k + 1) % corners.size()] - corners[k];
  };
  for (std::size_t k = 0; k < corners.size(); ++k) round += side(k).norm();
  double left = std::fmod(start + speed * time, round);
  std::size_t k = 0;
  while (k + 1 < corners.size() && left > side(k).norm()) left -= side(k++).norm();
  const Vector2d along = side(k).normalized();
  // Nobody turns on the spot: they look round over the first half metre.
  const Vector2d before = side((k + corners.size() - 1) % corners.size()).normalized();
  const double turn = std::min(1.0, left / 0.5);
  const Vector2d look =
      turn * along + (1.0 - turn) * (before + 0.05 * Vector2d(-before.y(), before.x()));
  return {corners[k] + left * along, look.normalized()};
}

Parts personAt(const Walk& walk, const YardGround& ground, double time) {
  const auto [place, look] = walk.at(time);
  const Vector3d foot(place.x(), ground.yAt(place.x(), place.y()), place.y());
  const Vector3d ahead(look.x(), 0.0, look.y()), right(look.y(), 0.0, -look.x());
  const auto at = [&](double across, double up, double forward) -> Vector3d {
    return foot + across * right - up * Vector3d::UnitY() + forward * ahead;
  };
  Parts parts;
  const auto add = [&](const Part& part, Material material, int variety) {
    parts.push_back(withLook(part, YardKind::Person, material, variety));
  };
  const double phase = 2 * std::numbers::pi * (walk.start + walk.speed * time) / stride;
  for (const double side : {-1.0, 1.0}) {
    const int variety = side > 0 ? 1 : 2;
    const double swing = side * std::sin(phase);
    const double bend = 0.12 * (1.0 + side * std::cos(phase));
    const Vector3d hip = at(0.10 * side, 0.92, 0.0);
    const Vector3d knee = at(0.10 * side, 0.50, 0.22 * swing + 0.04);
    const Vector3d ankle = at(0.10 * side, 0.08 + bend * 0.6, 0.34 * swing - bend);
    add(rod(hip, knee, 0.085), Material::Trousers, variety);
    add(rod(knee, ankle, 0.065), Material::Trousers, variety + 2);
    add(beam(ankle + 0.10 * ahead, ankle - 0.10 * ahead, 0.10, 0.09), Material::DarkSteel, variety);
    const Vector3d shoulder = at(0.25 * side, 1.42, 0.0);
    const Vector3d elbow = at(0.28 * side, 1.14, -0.14 * swing);
    const Vector3d hand = at(0.27 * side, 0.90, -0.26 * swing + 0.08);
    add(rod(shoulder, elbow, 0.055), Material::Vest, variety);
    add(rod(elbow, hand, 0.045), Material::Vest, variety + 2);
    add(ellipsoid(hand, Vector3d::Constant(0.11)), Material::Skin, variety);
  }
  add(beam(at(0, 1.50, 0), at(0, 0.88, 0), 0.24, 0.42, right), Material::Vest, 5);
  add(ellipsoid(at(0, 1.66, 0.01), {0.19, 0.25, 0.20}), Material::Skin, 6);
  add(ellipsoid(at(0, 1.74, 0.02), {0.27, 0.17, 0.29}), Material::Helmet, 7);
  return parts;
}

}  // namespace boomwatch
