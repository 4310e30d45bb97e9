#include "simulation/yard/lighting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr int mapSize = 1024;
constexpr double farAway = 200.0;  // metres: the rays are as good as parallel

/// Towards the sun, yard frame: left of the cameras and behind them.
Vector3d sunward() { return Vector3d(-0.55, -0.80, -0.30).normalized(); }

}  // namespace

YardShadows::YardShadows(const Parts& parts, const Eigen::Matrix3d& level, const Vector3d& middle,
                         double reach) {
  const Vector3d along = level.transpose() * -sunward();
  m_toSun.row(2) = along;
  m_toSun.row(0) = along.unitOrthogonal();
  m_toSun.row(1) = along.cross(along.unitOrthogonal());
  m_eye.camera = PinholeCamera::centred(mapSize, mapSize, mapSize / 2.0 / reach * farAway);
  m_eye.eye = m_toSun * middle - farAway * Vector3d::UnitZ();
  m_depth = cv::Mat(m_eye.size(), CV_32FC1, cv::Scalar(std::numeric_limits<double>::infinity()));
  Parts seen;
  seen.reserve(parts.size());
  for (const Part& part : parts) seen.push_back(turned(part, m_toSun));
  cv::Mat nobodyAsks;
  castParts(m_eye, seen, m_depth, nobodyAsks);
}

float YardShadows::sunAt(const Vector3d& place, const Vector3d& normal) const {
  // A little off the surface, or it would throw its shadow on itself.
  const Vector3d p = m_toSun * (place + 0.05 * normal) - m_eye.eye;
  const Eigen::Vector2d pixel = m_eye.camera.project(p);
  const double u = pixel.x(), v = pixel.y();
  if (!(u >= 0.0 && v >= 0.0 && u < mapSize - 1 && v < mapSize - 1)) return 1.0F;
  const int column = static_cast<int>(u), row = static_cast<int>(v);
  const auto s = static_cast<float>(u - column), t = static_cast<float>(v - row);
  const auto free = [&](int c, int r) {
    return static_cast<double>(m_depth.at<float>(r, c)) > p.z() - 0.02 ? 1.0F : 0.0F;
  };
  return (1 - t) * ((1 - s) * free(column, row) + s * free(column + 1, row)) +
         t * ((1 - s) * free(column, row + 1) + s * free(column + 1, row + 1));
}

Lighting lightingOf(const Vector3d& normal) {
  static const Vector3d sun = sunward();
  return {static_cast<float>(0.40 + 0.24 * (0.5 - 0.5 * normal.y())),
          static_cast<float>(0.56 * std::max(0.0, normal.dot(sun)))};
}

}  // namespace boomwatch
