#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "frame/cloud.h"
#include "simulation/scene_view.h"
#include "simulation/solids.h"
#include "tracking/tool_point.h"

/// Simulated truth for the load detector: a log in a grapple under a boom above a ground, as a
/// stereo camera of 768 x 576 pixels sees it.
namespace boomwatch::load_scene {

using Eigen::Vector3d;

struct Random {
  std::mt19937 engine;
  explicit Random(unsigned seed) : engine(seed) {}
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  double normal() { return std::normal_distribution<double>()(engine); }
  Vector3d direction() {
    Vector3d d;
    do d = Vector3d(normal(), normal(), normal());
    while (d.norm() < 0.1);
    return d.normalized();
  }
};

struct LoadScene {
  Ground ground;
  std::vector<Cylinder> cylinders;
  std::vector<OrientedBox> boxes;
  std::optional<Cylinder> log;  ///< also among `cylinders`
  Vector3d grapple;             ///< its middle, which a tracker would follow
  double focal = 600.0;
  double baseline = 0.25;

  /// Standard deviation of the inverse depth: a quarter of a pixel.
  double depthNoise() const { return 0.25 / (focal * baseline); }
};

inline OrientedBox boxAt(const Vector3d& centre, const Vector3d& x, const Vector3d& y,
                         const Vector3d& size) {
  OrientedBox box;
  box.centre = centre;
  box.size = size;
  box.rotation << x, y, x.cross(y);
  return box;
}

inline Vector3d across(const Vector3d& of, const Vector3d& wanted) {
  Vector3d a = wanted - of * of.dot(wanted);
  if (a.norm() < 0.05) a = of.unitOrthogonal();
  return a.normalized();
}

/// Rotator, housing and two pairs of bent arms that close around a thing `radius` thick whose axis
/// is `axis`; `up` points to the boom.
inline void addGrapple(LoadScene& scene, const Vector3d& centre, const Vector3d& axis,
                       const Vector3d& up, double radius, Random& random) {
  const Vector3d side = axis.cross(up);
  const double width = random(0.12, 0.3);
  scene.boxes.push_back(boxAt(centre + up * (radius + 0.16), axis, up, {0.35, 0.24, 0.3}));
  scene.cylinders.push_back({centre + up * (radius + 0.43), up, 0.3, random(0.08, 0.14)});
  for (const double sign : {-1.0, 1.0}) {
    const double spread = radius + 0.04;
    const Vector3d upper = (side * sign + up * 0.3).normalized();
    scene.boxes.push_back(boxAt(centre + side * sign * spread + up * radius * 0.4, axis,
                                axis.cross(upper).normalized(), {width, radius + 0.25, 0.05}));
    const Vector3d lower = (side * sign - up).normalized();
    scene.boxes.push_back(boxAt(centre + lower * spread, axis, axis.cross(lower).normalized(),
                                {width, radius + 0.1, 0.05}));
  }
  scene.grapple = centre + up * (radius * 0.5);
}

/// From the top of the grapple to the crane: two sections with a joint.
inline void addBoom(LoadScene& scene, const Vector3d& from, const Vector3d& up, Random& random) {
  const Vector3d knee = from + (up + 0.5 * random.direction()).normalized() * random(1.5, 3.0);
  const Vector3d crane = knee + (0.4 * up + random.direction()).normalized() * 3.0;
  const double thick = random(0.12, 0.25);
  for (const auto& [a, b] : {std::pair{from, knee}, std::pair{knee, crane}}) {
    const Vector3d along = (b - a).normalized();
    scene.boxes.push_back(
        boxAt((a + b) / 2.0, along, along.unitOrthogonal(), {(b - a).norm(), thick, thick}));
  }
}

/// The world's up in a camera that looks down by up to 50 degrees.
inline Vector3d randomUp(Random& random) {
  const double pitch = random(0.0, 50.0) * std::numbers::pi / 180.0;
  return {0.0, -std::cos(pitch), -std::sin(pitch)};
}

inline Vector3d randomPlace(Random& random) {
  const double z = random(3.0, 9.0);
  return {z * random(-0.3, 0.3), z * random(-0.2, 0.2), z};
}

inline bool inPicture(const LoadScene& scene, const Vector3d& p) {
  return p.z() > 0.3 && std::abs(p.x() / p.z()) * scene.focal < demoCamera.width / 2.0 - 12.0 &&
         std::abs(p.y() / p.z()) * scene.focal < demoCamera.height / 2.0 - 12.0;
}

/// A log 1.5 to 4 m long and 0.1 to 0.25 m in radius in any direction, wholly in the picture, but
/// for what cannot be seen: an axis within 20 degrees of the line of sight.
inline LoadScene logInGrapple(unsigned seed) {
  Random random(seed);
  LoadScene scene;
  scene.baseline = random(0.2, 0.3);
  const Vector3d up = randomUp(random);
  Cylinder log;
  bool fits = false;
  while (!fits) {
    log.centre = randomPlace(random);
    log.axis = random.direction();
    log.length = random(1.5, 4.0);
    log.radius = random(0.1, 0.25);
    const Vector3d half = log.axis * log.length / 2.0;
    fits = std::abs(log.axis.dot(log.centre.normalized())) <
               std::cos(20.0 * std::numbers::pi / 180.0) &&
           inPicture(scene, log.centre + half) && inPicture(scene, log.centre - half);
  }
  scene.log = log;
  scene.cylinders.push_back(log);
  const Vector3d held = log.centre + log.axis * log.length * random(-0.08, 0.08);
  const Vector3d grappleUp = across(log.axis, up);
  addGrapple(scene, held, log.axis, grappleUp, log.radius, random);
  addBoom(scene, held + grappleUp * (log.radius + 0.55), (grappleUp + up).normalized(), random);
  const double lowest = std::abs(log.axis.dot(up)) * log.length / 2.0 + log.radius;
  scene.ground.up = up;
  scene.ground.depth = -up.dot(log.centre) + lowest + random(0.4, 3.0);
  return scene;
}

/// The same without a log: an empty grapple, ajar or closed, above a ground or before a wall.
inline LoadScene emptyGrapple(unsigned seed) {
  Random random(seed);
  LoadScene scene;
  scene.baseline = random(0.2, 0.3);
  const Vector3d up = randomUp(random);
  const Vector3d centre = randomPlace(random);
  const Vector3d grappleUp = (up + 0.3 * random.direction()).normalized();
  const Vector3d axis = across(grappleUp, random.direction());
  addGrapple(scene, centre, axis, grappleUp, random(0.05, 0.2), random);
  addBoom(scene, centre + grappleUp * 0.7, (grappleUp + up).normalized(), random);
  scene.ground.up = up;
  scene.ground.depth = -up.dot(centre) + random(0.4, 3.0);
  if (seed % 3 == 0) {  // a wall behind it
    const Vector3d away = across(up, Vector3d(random(-0.5, 0.5), 0.0, 1.0));
    scene.boxes.push_back(boxAt(centre + away * (random(0.4, 2.0) + 0.5), away, up, {0.2, 20, 30}));
  }
  return scene;
}

/// The pixels that may show a solid whose corners or hull are given.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};
inline PixelBox pixelsOf(const std::array<Vector3d, 8>& corners, const PinholeCamera& camera) {
  PixelBox box{camera.width, camera.height, -1, -1};
  for (const Vector3d& p : corners) {
    if (p.z() < 0.05) return {0, 0, camera.width - 1, camera.height - 1};
    const double u = p.x() / p.z() * camera.fx + camera.cx;
    const double v = p.y() / p.z() * camera.fy + camera.cy;
    box.left = std::min(box.left, static_cast<int>(std::max(u, 0.0)));
    box.top = std::min(box.top, static_cast<int>(std::max(v, 0.0)));
    box.right = std::max(box.right, static_cast<int>(std::min(u + 1.0, camera.width - 1.0)));
    box.bottom = std::max(box.bottom, static_cast<int>(std::min(v + 1.0, camera.height - 1.0)));
  }
  return box;
}

/// The exact depths, row-major; 0 where nothing is hit.
inline std::vector<float> depthsOf(const LoadScene& scene, const PinholeCamera& camera) {
  std::vector<float> depths(static_cast<std::size_t>(camera.width) * camera.height, 0.0F);
  const auto draw = [&](const auto& solid, const PixelBox& box) {
    for (int v = box.top; v <= box.bottom; ++v) {
      for (int u = box.left; u <= box.right; ++u) {
        const auto hit = cast(solid, Vector3d::Zero(), camera.ray(u, v));
        if (!hit || hit->depth > SceneView::farthest) continue;
        float& depth = depths[static_cast<std::size_t>(v) * camera.width + u];
        if (depth == 0.0F || hit->depth < depth) depth = static_cast<float>(hit->depth);
      }
    }
  };
  draw(scene.ground, {0, 0, camera.width - 1, camera.height - 1});
  for (const OrientedBox& box : scene.boxes) draw(box, pixelsOf(box.corners(), camera));
  for (const Cylinder& c : scene.cylinders) {
    const Vector3d side = c.axis.unitOrthogonal();
    const OrientedBox hull =
        boxAt(c.centre, c.axis, side, {c.length, 2.0 * c.radius, 2.0 * c.radius});
    draw(c, pixelsOf(hull.corners(), camera));
  }
  return depths;
}

/// What the stereo camera gives: a quarter of a pixel of noise in the disparity, 5 % of the pixels
/// without depth, 1 % anywhere.
inline Cloud cloudOf(const LoadScene& scene, unsigned seed) {
  const auto camera = PinholeCamera::centred(demoCamera.width, demoCamera.height, scene.focal);
  Random random(seed + 1'000'000);
  std::minstd_rand quick(seed + 1);
  const auto share = [&] { return static_cast<double>(quick()) / 2147483647.0; };
  std::vector<float> noise(4093);  // a table: a million draws a frame would be most of the time
  for (float& n : noise) n = static_cast<float>(random.normal());
  Cloud cloud;
  cloud.width = camera.width;
  cloud.height = camera.height;
  cloud.camera = camera;
  const std::vector<float> depths = depthsOf(scene, camera);
  cloud.points.assign(depths.size(), unmeasuredPoint());
  for (std::size_t i = 0; i < depths.size(); ++i) {
    double z = depths[i];
    const double dice = share();
    if (dice < 0.05) continue;
    if (dice > 0.99) {
      z = 0.5 + 12.0 * share();
    } else if (z > 0.0) {
      z = 1.0 / (1.0 / z + scene.depthNoise() * noise[quick() % noise.size()]);
    }
    if (!(z > 0.0 && z < 100.0)) continue;
    const auto column = static_cast<int>(i) % camera.width,
               row = static_cast<int>(i) / camera.width;
    cloud.points[i] = (camera.ray(column, row) * z).cast<float>();
  }
  return cloud;
}

/// What a tracker of the grapple would give: the cloud's point at, or some pixels beside, its
/// middle. Absent where something hides the grapple: there is nothing to follow.
inline std::optional<Eigen::Vector3f> toolPointOf(const LoadScene& scene, const Cloud& cloud,
                                                  unsigned seed) {
  Random random(seed + 2'000'000);
  const Vector3d p = scene.grapple / scene.grapple.z() * scene.focal;
  const double jitter = 0.05 / scene.grapple.z() * scene.focal;
  const auto point =
      toolPointAt(cloud, {static_cast<int>(p.x() + demoCamera.cx + random(-jitter, jitter)),
                          static_cast<int>(p.y() + demoCamera.cy + random(-jitter, jitter))});
  const double sigma = scene.depthNoise() * scene.grapple.z() * scene.grapple.z();
  const double farthest = 0.5 + 3.0 * sigma;
  if (!point || (point->cast<double>() - scene.grapple).norm() > farthest) return std::nullopt;
  return point;
}

}  // namespace boomwatch::load_scene
