#include "simulation/yard/painter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "simulation/yard/material.h"
#include "simulation/yard/texture.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double nearest = 0.05;  // z at which a body is too near to be projected
constexpr int bandRows = 32;

/// The pixels of a few rows that the convex hull of projected points covers.
class Footprint {
 public:
  template <std::size_t N>
  Footprint(const std::array<Vector3d, N>& points, const YardEye& eye) {
    const PinholeCamera& camera = eye.camera;
    for (const Vector3d& point : points) {
      const Vector3d p = point - eye.eye;
      if (p.z() < nearest) {
        m_everywhere = true;
        return;
      }
      m_points[m_count++] = {camera.focal * p.x() / p.z() + camera.cx(),
                             camera.focal * p.y() / p.z() + camera.cy()};
    }
    for (std::size_t k = 0; k < m_count; ++k) {
      m_top = std::min(m_top, m_points[k].y());
      m_bottom = std::max(m_bottom, m_points[k].y());
    }
  }

  /// Calls work(u, v) for the pixels within `rows` and the picture's `width`.
  template <class Work>
  void forEach(const cv::Range& rows, int width, Work&& work) const {
    const auto bounded = [](double x) { return std::clamp(x, -1e6, 1e6); };
    const int from =
        m_everywhere ? rows.start : std::max(rows.start, int(std::ceil(bounded(m_top))));
    const int to =
        m_everywhere ? rows.end : std::min(rows.end, int(std::floor(bounded(m_bottom))) + 1);
    for (int v = from; v < to; ++v) {
      double left = -1.0, right = width;
      if (!m_everywhere) span(v, left, right);
      const int begin = std::max(0, int(std::ceil(bounded(left))));
      const int end = std::min(width, int(std::floor(bounded(right))) + 1);
      for (int u = begin; u < end; ++u) work(u, v);
    }
  }

 private:
  void span(double v, double& left, double& right) const {
    left = std::numeric_limits<double>::infinity();
    right = -left;
    for (std::size_t i = 0; i < m_count; ++i) {
      for (std::size_t j = i + 1; j < m_count; ++j) {
        const Eigen::Vector2d &a = m_points[i], &b = m_points[j];
        if ((a.y() > v) == (b.y() > v)) continue;
        const double u = a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        left = std::min(left, u);
        right = std::max(right, u);
      }
    }
  }

  std::array<Eigen::Vector2d, 8> m_points;
  std::size_t m_count = 0;
  bool m_everywhere = false;
  double m_top = std::numeric_limits<double>::infinity(), m_bottom = -m_top;
};

Vector3f sky(const Vector3d& ray) {
  const Vector3f direction = ray.normalized().cast<float>();
  const float up = std::clamp(-direction.y() * 3.0F, 0.0F, 1.0F);
  const Vector3f place(direction.x() * 3.0F, direction.y() * 9.0F, direction.z() * 3.0F);
  const float cloud = 14.0F * roughness(place, 1.0F, 5, 0.02F);
  return Vector3f(226.0F, 218.0F, 210.0F) + up * Vector3f(4.0F, -16.0F, -34.0F) +
         Vector3f::Constant(cloud);
}

/// A bright, slightly clouded day: light from all over the sky, more from the sun's side.
float lightOn(const Vector3d& levelNormal) {
  static const Vector3d sun = Vector3d(-0.55, -0.75, -0.40).normalized();
  const double fromSky = 0.5 - 0.5 * levelNormal.y();
  return static_cast<float>(0.34 + 0.26 * fromSky + 0.52 * std::max(0.0, levelNormal.dot(sun)));
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
  return static_cast<float>(z / eye.camera.focal / std::sqrt(slant));
}

cv::Vec3b colourOf(const Part& part, const YardEye& eye, const Vector3d& ray, const Hit& hit) {
  const Vector3d local =
      part.box.rotation.transpose() * (eye.eye + hit.depth * ray - part.box.centre);
  const Vector3d normal = part.box.rotation.transpose() * hit.normal;
  const Vector3f paint = paintOf(part, {local.cast<float>(), normal.cast<float>(),
                                        footprintAt(eye, hit.depth, hit.normal, ray)});
  return developed(paint * lightOn(eye.level * hit.normal), hit.depth);
}

/// Runs work(rows) for bands of rows in parallel.
template <class Work>
void inBands(int height, Work&& work) {
  const int bands = (height + bandRows - 1) / bandRows;
  cv::parallel_for_(cv::Range(0, bands), [&](const cv::Range& range) {
    for (int band = range.start; band < range.end; ++band) {
      work(cv::Range(band * bandRows, std::min(height, (band + 1) * bandRows)));
    }
  });
}

void castGround(const YardEye& eye, const std::vector<YardGround::Triangle>& triangles,
                const cv::Range& rows, YardPicture& picture) {
  for (const YardGround::Triangle& t : triangles) {
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double distance = normal.dot(t[0] - eye.eye);
    Footprint(t, eye).forEach(rows, eye.camera.width, [&](int u, int v) {
      const auto z = static_cast<float>(distance / normal.dot(eye.camera.ray(u, v)));
      float& depth = picture.depth.at<float>(v, u);
      if (z > 0.0F && z < depth) depth = z;
    });
  }
}

void colourGround(const YardEye& eye, const YardGround& ground, const cv::Range& rows,
                  YardPicture& picture) {
  for (int v = rows.start; v < rows.end; ++v) {
    for (int u = 0; u < eye.camera.width; ++u) {
      const Vector3d ray = eye.camera.ray(u, v);
      const double z = static_cast<double>(picture.depth.at<float>(v, u));
      if (!std::isfinite(z)) {
        const Vector3f colour = sky(eye.level * ray);
        picture.colour.at<cv::Vec3b>(v, u) = developed(colour, 0.0);
        continue;
      }
      const Vector3d place = eye.level * (eye.eye + z * ray);
      const Vector3d normal = ground.normalAt(place.x(), place.z());
      const float footprint = footprintAt(eye, z, normal, eye.level * ray);
      const Vector3f paint = paintOfGround({place.cast<float>(), normal.cast<float>(), footprint});
      picture.colour.at<cv::Vec3b>(v, u) = developed(paint * lightOn(normal), z);
      picture.kind.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(YardKind::Ground);
    }
  }
}

constexpr std::int16_t nobody = -1;

/// Depth, and in `owner` (whose first row is rows.start) which part is seen.
void castParts(const YardEye& eye, const Parts& parts, const cv::Range& rows, YardPicture& picture,
               cv::Mat& owner) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Part& part = parts[k];
    Footprint(part.box.corners(), eye).forEach(rows, eye.camera.width, [&](int u, int v) {
      const Vector3d ray = eye.camera.ray(u, v);
      float& depth = picture.depth.at<float>(v, u);
      const auto hit = cast(part, eye.eye, ray);
      if (!hit || static_cast<float>(hit->depth) >= depth) return;
      if (part.material == Material::Foliage) {
        const Vector3d at =
            part.box.rotation.transpose() * (eye.eye + hit->depth * ray - part.box.centre);
        if (isGap(part, at.cast<float>())) return;
      }
      depth = static_cast<float>(hit->depth);
      owner.at<std::int16_t>(v - rows.start, u) = static_cast<std::int16_t>(k);
    });
  }
}

void colourParts(const YardEye& eye, const Parts& parts, const cv::Range& rows,
                 const cv::Mat& owner, YardPicture& picture) {
  for (int v = rows.start; v < rows.end; ++v) {
    for (int u = 0; u < eye.camera.width; ++u) {
      const std::int16_t k = owner.at<std::int16_t>(v - rows.start, u);
      if (k == nobody) continue;
      const Part& part = parts[static_cast<std::size_t>(k)];
      const Vector3d ray = eye.camera.ray(u, v);
      const auto hit = cast(part, eye.eye, ray);
      if (!hit) continue;  // cannot be: it was hit before
      picture.colour.at<cv::Vec3b>(v, u) = colourOf(part, eye, ray, *hit);
      picture.kind.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(part.kind);
    }
  }
}

}  // namespace

YardPicture paintGround(const YardEye& eye, const YardGround& ground) {
  const cv::Size size(eye.camera.width, eye.camera.height);
  YardPicture picture{cv::Mat(size, CV_8UC3),
                      cv::Mat(size, CV_32FC1, cv::Scalar(std::numeric_limits<double>::infinity())),
                      cv::Mat(size, CV_8UC1, cv::Scalar(static_cast<double>(YardKind::Nothing)))};
  std::vector<YardGround::Triangle> triangles = ground.triangles();
  for (auto& triangle : triangles) {
    for (Vector3d& corner : triangle) corner = eye.level.transpose() * corner;
  }
  inBands(eye.camera.height, [&](const cv::Range& rows) {
    castGround(eye, triangles, rows, picture);
    colourGround(eye, ground, rows, picture);
  });
  return picture;
}

void paint(const YardEye& eye, const Parts& parts, YardPicture& picture) {
  inBands(eye.camera.height, [&](const cv::Range& rows) {
    cv::Mat owner(rows.size(), eye.camera.width, CV_16SC1, cv::Scalar(nobody));
    castParts(eye, parts, rows, picture, owner);
    colourParts(eye, parts, rows, owner, picture);
  });
}

cv::Mat silhouetteOf(const YardEye& eye, const Parts& parts) {
  cv::Mat silhouette(eye.camera.height, eye.camera.width, CV_8UC1, cv::Scalar(0));
  inBands(eye.camera.height, [&](const cv::Range& rows) {
    for (const Part& part : parts) {
      Footprint(part.box.corners(), eye).forEach(rows, eye.camera.width, [&](int u, int v) {
        std::uint8_t& pixel = silhouette.at<std::uint8_t>(v, u);
        if (pixel == 0 && cast(part, eye.eye, eye.camera.ray(u, v))) pixel = 255;
      });
    }
  });
  return silhouette;
}

}  // namespace boomwatch
