#include "simulation/yard/yard_layout.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr double cameraHeight = 3.4;

class Planter {
 public:
  Planter(YardLayout& layout, std::uint64_t seed) : m_layout(layout), m_dice(seed, 1) {}

  void plant() {
    stack({-3.1, 7.6}, 0.30, 6);
    stack({4.6, 11.2}, 1.45, 5);
    wall({2.9, 8.0}, -0.32);
    const Eigen::Vector2d trees[] = {
        {-0.5, 9.4}, {-4.6, 6.1}, {5.1, 7.2}, {1.2, 11.5}, {-3.0, 12.0}};
    for (const Eigen::Vector2d& place : trees) nearTree(place);
    stump({-1.9, 5.9});
    stump({1.7, 6.3});
    wood();
  }

 private:
  double about(double value, double spread) {
    return m_dice.uniform(value - spread, value + spread);
  }
  Vector3d onGround(double x, double z) const { return {x, m_layout.ground.yAt(x, z), z}; }
  int variety() { return m_dice.below(256); }
  void add(const Part& part, YardKind kind, Material material) {
    m_layout.fixed.push_back(withLook(part, kind, material, variety()));
  }

  /// Logs in a heap, `widest` of them in the lowest layer, along (sin turn, cos turn).
  void stack(const Eigen::Vector2d& place, double turn, int widest) {
    turn = about(turn, 0.15);
    const Vector3d centre = onGround(about(place.x(), 0.25), about(place.y(), 0.25));
    const Vector3d along(std::sin(turn), 0.0, std::cos(turn));
    const Vector3d across(std::cos(turn), 0.0, -std::sin(turn));
    constexpr double r = 0.17;
    for (int layer = 0; layer < widest - 1; ++layer) {
      for (int k = 0; k < widest - layer; ++k) {
        const double side = (k - (widest - layer - 1) / 2.0) * 2.0 * r;
        const double up = r + layer * 1.74 * r;
        const Vector3d middle = centre + side * across - (up - 0.06) * Vector3d::UnitY() +
                                m_dice.uniform(-0.18, 0.18) * along;
        const double half = about(1.5, 0.06);
        add(rod(middle - half * along, middle + half * along, about(0.155, 0.014)), YardKind::Stack,
            Material::Log);
      }
    }
  }

  void wall(const Eigen::Vector2d& place, double turn) {
    turn = about(turn, 0.12);
    const Vector3d foot = onGround(about(place.x(), 0.2), about(place.y(), 0.2));
    Part part;
    part.box = {
        foot - Vector3d(0.0, 0.75, 0.0), {3.6, 2.1, 0.3}, rotationFromYawPitchRoll(turn, 0.0, 0.0)};
    add(part, YardKind::Wall, Material::Concrete);
  }

  void stump(const Eigen::Vector2d& place) {
    const Vector3d foot = onGround(about(place.x(), 0.3), about(place.y(), 0.3));
    add(rod(foot + Vector3d(0.0, 0.2, 0.0), foot - Vector3d(0.0, about(0.26, 0.06), 0.0), 0.2),
        YardKind::Tree, Material::Log);
  }

  /// A trunk whose crown is above the picture, with branches on it, some dry, some with leaves.
  void nearTree(const Eigen::Vector2d& place) {
    const Vector3d foot = onGround(about(place.x(), 0.2), about(place.y(), 0.2));
    const Vector3d lean = Vector3d(about(0.0, 0.04), -1.0, about(0.0, 0.04)).normalized();
    const double radius = about(0.19, 0.04);
    const int bark = variety();
    for (int k = 0; k < 3; ++k) {
      m_layout.fixed.push_back(
          withLook(rod(foot + (k * 2.6 - 0.2) * lean, foot + (k * 2.6 + 2.45) * lean,
                       radius * (1.0 - 0.16 * k)),
                   YardKind::Tree, Material::Bark, bark));
    }
    for (int k = 0; k < 9; ++k) {
      const double height = 1.3 + 0.36 * k;
      const double turn = m_dice.uniform(0.0, 2.0 * std::numbers::pi);
      const Vector3d out =
          Vector3d(std::cos(turn), m_dice.uniform(-0.45, 0.05), std::sin(turn)).normalized();
      const Vector3d root = foot + height * lean + 0.8 * radius * out;
      if (k % 3 == 1 && height > 2.0) {
        bough(root, out);
      } else {
        add(rod(root, root + about(0.6, 0.25) * out, about(0.024, 0.008)), YardKind::Tree,
            Material::DryBranch);
      }
    }
  }

  void bough(const Vector3d& root, const Vector3d& out) {
    Bough bough;
    bough.root = root;
    bough.axis = out.cross(Vector3d::UnitY()).normalized();
    bough.period = about(2.6, 0.6);
    bough.phase = m_dice.uniform(0.0, 2.0 * std::numbers::pi);
    bough.swing = about(0.06, 0.02);
    const double length = about(1.0, 0.15);
    bough.parts.push_back(withLook(rod(root, root + length * out, 0.022), YardKind::Branch,
                                   Material::DryBranch, variety()));
    for (int k = 0; k < 4; ++k) {
      const Vector3d at = root + (0.45 + 0.2 * k) * length * out +
                          Vector3d(about(0, 0.12), about(0.02, 0.05), about(0, 0.12));
      const Eigen::Matrix3d turn =
          rotationFromYawPitchRoll(about(0, 3), about(0.0, 0.35), about(0.0, 0.35));
      bough.parts.push_back(
          withLook(ellipsoid(at, {about(0.50, 0.1), 0.12, about(0.42, 0.1)}, turn),
                   YardKind::Branch, Material::Foliage, variety()));
    }
    m_layout.boughs.push_back(std::move(bough));
  }

  /// Spruces behind the yard.
  void wood() {
    for (int k = 0; k < 46; ++k) {
      const double z = 15.0 + 0.34 * k + about(0.0, 0.8);
      const double x = m_dice.uniform(-0.72, 0.72) * z;
      const Vector3d foot = onGround(x, z);
      const double height = about(9.0, 2.0), width = about(3.2, 0.5);
      add(rod(foot, foot - height * Vector3d::UnitY(), 0.15), YardKind::Tree, Material::Bark);
      const int tint = variety();
      for (int layer = 0; layer < 8; ++layer) {
        const double share = layer / 8.0;
        const Vector3d centre = foot - (0.9 + share * (height - 1.0)) * Vector3d::UnitY();
        const double across = width * (1.0 - share) + 0.35;
        m_layout.fixed.push_back(withLook(ellipsoid(centre, {across, 0.24 * height, across}),
                                          YardKind::Tree, Material::Foliage, tint));
      }
    }
  }

  YardLayout& m_layout;
  Dice m_dice;
};

}  // namespace

YardLayout::YardLayout(std::uint64_t seed) : ground(seed, cameraHeight) {
  Planter(*this, seed).plant();
  Dice dice(seed, 2);
  walk.corners = {{-2.2, 10.7}, {1.1, 10.4}, {1.0, 8.8}, {-1.3, 8.7}};
  walk.start = dice.uniform(0.0, 12.0);
  walk.speed = dice.uniform(0.9, 1.3);
  crane.pillar.y() = ground.yAt(crane.pillar.x(), crane.pillar.z());
  log.length = dice.uniform(2.1, 2.9);
  log.radius = dice.uniform(0.13, 0.19);
  log.tilt = dice.uniform(-0.06, 0.06);
}

Parts boughsAt(const std::vector<Bough>& boughs, double time) {
  Parts parts;
  for (const Bough& bough : boughs) {
    const double angle =
        bough.swing * std::sin(2.0 * std::numbers::pi * time / bough.period + bough.phase);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, bough.axis).toRotationMatrix();
    for (Part part : bough.parts) {
      part.box.centre = bough.root + turn * (part.box.centre - bough.root);
      part.box.rotation = turn * part.box.rotation;
      parts.push_back(part);
    }
  }
  return parts;
}

}  // namespace boomwatch
