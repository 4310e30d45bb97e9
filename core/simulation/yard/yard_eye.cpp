#include "simulation/yard/yard_eye.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/row_bands.h"
#include "simulation/yard/surface_place.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

constexpr double nearest = 0.05;  // z at which a body is too near to be projected

/// The pixels of a few rows that the convex hull of projected points covers.
class Footprint {
 public:
  template <std::size_t N>
  Footprint(const std::array<Vector3d, N>& points, const YardEye& eye) {
    static_assert(N <= 8);
    for (const Vector3d& point : points) {
      const Vector3d p = point - eye.eye;
      if (p.z() < nearest) {
        m_everywhere = true;
        return;
      }
      m_points[m_count++] = eye.camera.project(p);
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

std::vector<Footprint> footprintsOf(const Parts& parts, const YardEye& eye) {
  std::vector<Footprint> footprints;
  footprints.reserve(parts.size());
  for (const Part& part : parts) footprints.emplace_back(part.box.corners(), eye);
  return footprints;
}

}  // namespace

void castParts(const YardEye& eye, const Parts& parts, cv::Mat& depth, cv::Mat& owner) {
  const std::vector<Footprint> footprints = footprintsOf(parts, eye);
  inBands(eye.camera.height, [&](const cv::Range& rows) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Part& part = parts[k];
      footprints[k].forEach(rows, eye.camera.width, [&](int u, int v) {
        const Vector3d ray = eye.camera.ray(u, v);
        float& z = depth.at<float>(v, u);
        const auto hit = cast(part, eye.eye, ray);
        if (!hit || static_cast<float>(hit->depth) >= z) return;
        if (part.material == Material::Foliage) {
          const Vector3d at =
              part.box.rotation.transpose() * (eye.eye + hit->depth * ray - part.box.centre);
          if (isGap(part, at.cast<float>())) return;
        }
        z = static_cast<float>(hit->depth);
        if (!owner.empty()) owner.at<std::int16_t>(v, u) = static_cast<std::int16_t>(k);
      });
    }
  });
}

void castTriangles(const YardEye& eye, const std::vector<YardGround::Triangle>& triangles,
                   cv::Mat& depth) {
  std::vector<Footprint> footprints;
  footprints.reserve(triangles.size());
  for (const auto& triangle : triangles) footprints.emplace_back(triangle, eye);
  inBands(eye.camera.height, [&](const cv::Range& rows) {
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const YardGround::Triangle& t = triangles[k];
      const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
      const double distance = normal.dot(t[0] - eye.eye);
      footprints[k].forEach(rows, eye.camera.width, [&](int u, int v) {
        const auto z = static_cast<float>(distance / normal.dot(eye.camera.ray(u, v)));
        float& nearestZ = depth.at<float>(v, u);
        if (z > 0.0F && z < nearestZ) nearestZ = z;
      });
    }
  });
}

cv::Mat silhouetteOf(const YardEye& eye, const Parts& parts) {
  cv::Mat silhouette(eye.size(), CV_8UC1, cv::Scalar(0));
  const std::vector<Footprint> footprints = footprintsOf(parts, eye);
  inBands(eye.camera.height, [&](const cv::Range& rows) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      footprints[k].forEach(rows, eye.camera.width, [&](int u, int v) {
        std::uint8_t& pixel = silhouette.at<std::uint8_t>(v, u);
        if (pixel == 0 && cast(parts[k], eye.eye, eye.camera.ray(u, v))) pixel = 255;
      });
    }
  });
  return silhouette;
}

}  // namespace boomwatch
