#include "simulation/yard/crane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace boomwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double pillarHeight = 2.2, mainLength = 3.9, jibLength = 2.7, minExtension = 0.3;

/// From the grapple's own axes (x across the log, y down, z along it) to the yard's.
struct Hanging {
  Vector3d tip;
  Matrix3d rotation;

  explicit Hanging(const CranePose& pose) : tip(pose.tip) {
    rotation = (Eigen::AngleAxisd(pose.swingX, Vector3d::UnitZ()) *
                Eigen::AngleAxisd(pose.swingZ, Vector3d::UnitX()) *
                Eigen::AngleAxisd(pose.yaw, Vector3d::UnitY()))
                   .toRotationMatrix();
  }
  Vector3d at(double x, double y, double z) const { return tip + rotation * Vector3d(x, y, z); }
};

/// Where the elbow is, above the line from shoulder to tip.
Vector3d elbowOf(const Vector3d& shoulder, const Vector3d& tip, double outer) {
  const Vector3d line = tip - shoulder;
  const double length = line.norm();
  const Vector3d along = line / length;
  const Vector3d up = (-Vector3d::UnitY() + along * along.y()).normalized();
  const double foot = (mainLength * mainLength - outer * outer + length * length) / (2 * length);
  const double height = std::sqrt(std::max(0.0, mainLength * mainLength - foot * foot));
  return shoulder + foot * along + height * up;
}

void addBoom(Parts& parts, const Vector3d& pillar, const Vector3d& tip) {
  const auto crane = [&](const Part& part, Material material, int variety) {
    parts.push_back(withLook(part, YardKind::Crane, material, variety));
  };
  const Vector3d shoulder = pillar - Vector3d(0.0, pillarHeight, 0.0);
  const double reach = (tip - shoulder).norm();
  const double outer = std::max(jibLength + minExtension, reach - 0.78 * mainLength);
  const Vector3d elbow = elbowOf(shoulder, tip, outer);
  const Vector3d side = (elbow - shoulder).cross(tip - elbow).normalized();
  const Vector3d main = (elbow - shoulder).normalized(), jib = (tip - elbow).normalized();
  crane(rod(pillar, shoulder, 0.16), Material::DarkSteel, 1);
  crane(beam(shoulder - 0.1 * main, elbow + 0.15 * main, 0.20, 0.24, side), Material::Paint, 2);
  crane(beam(elbow - 0.2 * jib, elbow + jibLength * jib, 0.17, 0.20, side), Material::Paint, 3);
  crane(beam(elbow + jib, tip, 0.11, 0.13, side), Material::DarkSteel, 4);
  const Vector3d above = side.cross(jib).y() < 0.0 ? side.cross(jib) : jib.cross(side);
  crane(rod(elbow + 0.1 * jib + 0.17 * above, elbow + 1.5 * jib + 0.17 * above, 0.05),
        Material::Chrome, 5);
  crane(rod(elbow + 1.5 * jib + 0.17 * above, elbow + 2.5 * jib + 0.17 * above, 0.03),
        Material::Chrome, 6);
  crane(rod(tip - 0.09 * side, tip + 0.09 * side, 0.09), Material::DarkSteel, 7);
}

/// A claw on the side given (-1 or 1): three plates bent around the log, seen along it.
void addClaw(Parts& parts, const Hanging& hang, const CarriedLog& log, double side, double z) {
  const double r = log.radius + 0.05, middle = log.drop();
  const Eigen::Vector2d path[] = {{0.16, 0.84},
                                  {r + 0.14, middle - 0.35 * r},
                                  {r + 0.02, middle + 0.55 * r},
                                  {0.25 * r, middle + 1.15 * r}};
  for (std::size_t k = 0; k + 1 < std::size(path); ++k) {
    const Vector3d a = hang.at(side * path[k].x(), path[k].y(), z);
    const Vector3d b = hang.at(side * path[k + 1].x(), path[k + 1].y(), z);
    parts.push_back(withLook(beam(a, b, 0.06, 0.10, hang.rotation.col(2)), YardKind::Tool,
                             Material::Grapple, static_cast<int>(k)));
  }
}

void addGrapple(Parts& parts, const CranePose& pose, const CarriedLog& log) {
  const Hanging hang(pose);
  const auto tool = [&](const Part& part, Material material, int variety) {
    parts.push_back(withLook(part, YardKind::Tool, material, variety));
  };
  tool(beam(hang.at(0, 0.04, 0), hang.at(0, 0.34, 0), 0.10, 0.12, hang.rotation.col(2)),
       Material::DarkSteel, 20);
  tool(rod(hang.at(0, 0.30, 0), hang.at(0, 0.58, 0), 0.15), Material::Paint, 21);
  tool(rod(hang.at(0, 0.40, 0), hang.at(0, 0.44, 0), 0.17), Material::Chrome, 22);
  tool(beam(hang.at(0, 0.58, 0), hang.at(0, 0.84, 0), 0.50, 0.34, hang.rotation.col(2)),
       Material::Grapple, 23);
  tool(rod(hang.at(-0.30, 0.76, 0), hang.at(0.30, 0.76, 0), 0.07), Material::Chrome, 24);
  for (const double side : {-1.0, 1.0}) {
    addClaw(parts, hang, log, side, side > 0 ? 0.0 : -0.13);
    if (side < 0) addClaw(parts, hang, log, side, 0.13);
  }
}

}  // namespace

Parts Crane::partsAt(const CranePose& pose, const CarriedLog& log) const {
  Parts parts;
  addBoom(parts, pillar, pose.tip);
  addGrapple(parts, pose, log);
  return parts;
}

Part logAt(const CranePose& pose, const CarriedLog& log) {
  const Hanging hang(pose);
  const Vector3d centre = hang.at(0, log.drop(), 0);
  const Vector3d half =
      hang.rotation * Vector3d(0, std::sin(log.tilt), std::cos(log.tilt)) * log.length / 2;
  return withLook(rod(centre - half, centre + half, log.radius), YardKind::Load, Material::Log, 77);
}

Vector3d toolPointAt(const CranePose& pose) { return Hanging(pose).at(0, 0.44, 0); }

}  // namespace boomwatch
