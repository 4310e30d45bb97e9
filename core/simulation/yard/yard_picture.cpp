#include "simulation/yard/yard_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/row_bands.h"
#include "simulation/yard/surface_place.h"
#include "simulation/yard/texture.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

Vector3f sky(const Vector3d& ray) {
  const Vector3f direction = ray.normalized().cast<float>();
  const float up = std::clamp(-direction.y() * 3.0F, 0.0F, 1.0F);
  const Vector3f place(direction.x() * 3.0F, direction.y() * 9.0F, direction.z() * 3.0F);
  const float cloud = 14.0F * roughness(place, 1.0F, 5, 0.02F);
  return Vector3f(226.0F, 218.0F, 210.0F) + up * Vector3f(4.0F, -16.0F, -34.0F) +
         Vector3f::Constant(cloud);
}

/// Far things fade into the haze.
cv::Vec3b developed(const Vector3f& colour, double z) {
  const float haze = 1.0F - std::exp(-static_cast<float>(z) / 90.0F);
  const Vector3f seen = colour + haze * (Vector3f(214.0F, 208.0F, 200.0F) - colour);
  return {cv::saturate_cast<std::uint8_t>(seen.x()), cv::saturate_cast<std::uint8_t>(seen.y()),
          cv::saturate_cast<std::uint8_t>(seen.z())};
}

/// Metres that a pixel covers at `z` on a surface that the ray meets under a slant.
float footprintAt(const YardEye& eye, double z, const Vector3d& normal, const Vector3d& ray) {
  const double slant = std::max(0.25, std::abs(normal.dot(ray)) / ray.norm());
  return static_cast<float>(z / eye.camera.fx / std::sqrt(slant));
}

/// The pixel's colour, and the share of its light that comes from the sun.
void put(YardPicture& picture, int u, int v, const Vector3f& paint, const Lighting& light,
         float inSun, double z) {
  const float sun = light.sun * inSun;
  picture.colour.at<cv::Vec3b>(v, u) = developed(paint * (light.sky + sun), z);
  picture.sun.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(255.0F * sun / (light.sky + sun));
}

void colourGround(const YardEye& eye, const YardGround& ground, const YardShadows& shadows,
                  const cv::Range& rows, YardPicture& picture) {
  for (int v = rows.start; v < rows.end; ++v) {
    for (int u = 0; u < eye.camera.width; ++u) {
      const Vector3d ray = eye.camera.ray(u, v);
      const double z = static_cast<double>(picture.depth.at<float>(v, u));
      if (!std::isfinite(z)) {
        picture.colour.at<cv::Vec3b>(v, u) = developed(sky(eye.level * ray), 0.0);
        continue;
      }
      const Vector3d p = eye.eye + z * ray, place = eye.level * p;
      const Vector3d normal = ground.normalAt(place.x(), place.z());
      const float footprint = footprintAt(eye, z, normal, eye.level * ray);
      put(picture, u, v, paintOfGround({place.cast<float>(), normal.cast<float>(), footprint}),
          lightingOf(normal), shadows.sunAt(p, eye.level.transpose() * normal), z);
      picture.kind.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(YardKind::Ground);
    }
  }
}

void colourPart(const YardEye& eye, const Part& part, const YardShadows& shadows, int u, int v,
                YardPicture& picture) {
  const Vector3d ray = eye.camera.ray(u, v);
  const auto hit = cast(part, eye.eye, ray);
  if (!hit) return;  // cannot be: it was hit before
  const Vector3d p = eye.eye + hit->depth * ray;
  const Vector3d local = part.box.rotation.transpose() * (p - part.box.centre);
  const Vector3d normal = part.box.rotation.transpose() * hit->normal;
  const Vector3f paint = paintOf(part, {local.cast<float>(), normal.cast<float>(),
                                        footprintAt(eye, hit->depth, hit->normal, ray)});
  put(picture, u, v, paint, lightingOf(eye.level * hit->normal), shadows.sunAt(p, hit->normal),
      hit->depth);
  picture.kind.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(part.kind);
}

}  // namespace

YardPicture paintGround(const YardEye& eye, const YardGround& ground, const YardShadows& shadows) {
  const cv::Size size = eye.size();
  YardPicture picture{cv::Mat(size, CV_8UC3),
                      cv::Mat(size, CV_32FC1, cv::Scalar(std::numeric_limits<double>::infinity())),
                      cv::Mat(size, CV_8UC1, cv::Scalar(static_cast<double>(YardKind::Nothing))),
                      cv::Mat(size, CV_8UC1, cv::Scalar(0))};
  std::vector<YardGround::Triangle> triangles = ground.triangles();
  for (auto& triangle : triangles) {
    for (Vector3d& corner : triangle) corner = eye.level.transpose() * corner;
  }
  castTriangles(eye, triangles, picture.depth);
  inBands(size.height,
          [&](const cv::Range& rows) { colourGround(eye, ground, shadows, rows, picture); });
  return picture;
}

void paint(const YardEye& eye, const Parts& parts, const YardShadows& shadows,
           YardPicture& picture) {
  cv::Mat owner(eye.size(), CV_16SC1, cv::Scalar(nobody));
  castParts(eye, parts, picture.depth, owner);
  inBands(owner.rows, [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      for (int u = 0; u < owner.cols; ++u) {
        const std::int16_t k = owner.at<std::int16_t>(v, u);
        if (k == nobody) continue;
        colourPart(eye, parts[static_cast<std::size_t>(k)], shadows, u, v, picture);
      }
    }
  });
}

void shade(const YardEye& eye, const YardShadows& shadows, double farthest, YardPicture& picture) {
  inBands(eye.camera.height, [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      for (int u = 0; u < eye.camera.width; ++u) {
        const double z = static_cast<double>(picture.depth.at<float>(v, u));
        const std::uint8_t sun = picture.sun.at<std::uint8_t>(v, u);
        if (sun == 0 || !(z < farthest)) continue;
        const float shadow =
            1.0F - shadows.sunAt(eye.eye + z * eye.camera.ray(u, v), Vector3d::Zero());
        if (shadow == 0.0F) continue;
        cv::Vec3b& colour = picture.colour.at<cv::Vec3b>(v, u);
        const float left = 1.0F - shadow * static_cast<float>(sun) / 255.0F;
        for (int k = 0; k < 3; ++k) colour[k] = cv::saturate_cast<std::uint8_t>(left * colour[k]);
      }
    }
  });
}

}  // namespace boomwatch
