#include "load/box_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "load/depth_plane.h"
#include "load/load_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr LoadTuning::Box tuning;

bool atBorder(const DepthPatch& patch, int cell) {
  const double u = patch.u0 + (cell % patch.side + 0.5) * patch.cell;
  const double v = patch.v0 + (cell / patch.side + 0.5) * patch.cell, room = 1.5 * patch.cell;
  return u < patch.uMin + room || u > patch.uMax - room || v < patch.vMin + room ||
         v > patch.vMax - room;
}

/// The body's cells without the pieces outside the tool that go on to the limit.
std::vector<int> withoutBoom(const DepthPatch& patch, const LoadBody& body, double reach,
                             double toolRadius) {
  if (toolRadius <= 0.0) return body.cells;  // nothing is held, and so no boom is there
  const auto cells = static_cast<std::size_t>(patch.side) * static_cast<std::size_t>(patch.side);
  std::vector<char> outer(cells, 0);
  std::vector<int> kept;
  for (std::size_t i = 0; i < body.cells.size(); ++i) {
    const bool inTool = (body.points[i] - body.tool).norm() <= toolRadius;
    if (inTool) kept.push_back(body.cells[i]);
    outer[static_cast<std::size_t>(body.cells[i])] = inTool ? 0 : 1;
  }
  for (const int start : body.cells) {
    if (outer[static_cast<std::size_t>(start)] == 0) continue;
    std::vector<int> piece{start};
    outer[static_cast<std::size_t>(start)] = 0;
    bool goesOn = false;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const int cell = piece[next], column = cell % patch.side, row = cell / patch.side;
      goesOn = goesOn || atBorder(patch, cell) ||
               (patch.point(cell) - body.tool).norm() > tuning.boomLimit * reach;
      for (int y = std::max(0, row - 1); y <= std::min(patch.side - 1, row + 1); ++y) {
        for (int x = std::max(0, column - 1); x <= std::min(patch.side - 1, column + 1); ++x) {
          char& open = outer[static_cast<std::size_t>(y * patch.side + x)];
          if (open != 0) piece.push_back(y * patch.side + x);
          open = 0;
        }
      }
    }
    if (!goesOn) kept.insert(kept.end(), piece.begin(), piece.end());
  }
  return kept;
}

/// Axes of the smallest rectangle about `normal` that holds the points' shadow.
Matrix3d axesAbout(const Vector3d& normal, const std::vector<Vector3d>& points) {
  const Vector3d a = normal.unitOrthogonal(), b = normal.cross(a);
  std::vector<cv::Point2f> shadow;
  shadow.reserve(points.size());
  for (const Vector3d& p : points) {
    shadow.emplace_back(static_cast<float>(a.dot(p)), static_cast<float>(b.dot(p)));
  }
  const double turn = cv::minAreaRect(shadow).angle * M_PI / 180.0;
  Matrix3d axes;
  axes.col(0) = a * std::cos(turn) + b * std::sin(turn);
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

/// About all but the outermost points on each side.
OrientedBox boxAlong(const Matrix3d& axes, const std::vector<Vector3d>& points, double grow) {
  OrientedBox box;
  box.rotation = axes;
  std::vector<double> values(points.size());
  for (int i = 0; i < 3; ++i) {
    std::transform(points.begin(), points.end(), values.begin(),
                   [&](const Vector3d& p) { return axes.col(i).dot(p); });
    const auto skip =
        static_cast<std::ptrdiff_t>(tuning.outermost * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + skip, values.end());
    const double low = values[static_cast<std::size_t>(skip)];
    std::nth_element(values.begin(), values.end() - 1 - skip, values.end());
    const double high = *(values.end() - 1 - skip);
    box.size[i] = high - low + 2.0 * grow;
    box.centre += axes.col(i) * (low + high) / 2.0;
  }
  return box;
}

Matrix3d principalAxes(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p / static_cast<double>(points.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const Vector3d& p : points) spread += (p - mean) * (p - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(spread).eigenvectors();
}

/// Of what the box covers in the picture and nothing else hides, the share that is the body.
double filledShare(const OrientedBox& box, const DepthPatch& patch, const std::vector<int>& cells) {
  std::vector<cv::Point2f> corners, hull;
  double nearest = 0.0;  // inverse depth
  for (const Vector3d& p : box.corners()) {
    if (p.z() < tuning.minDepth) return 0.0;
    corners.emplace_back(static_cast<float>((p.x() / p.z() - patch.u0) / patch.cell),
                         static_cast<float>((p.y() / p.z() - patch.v0) / patch.cell));
    nearest = std::max(nearest, 1.0 / p.z());
  }
  std::vector<char> own(patch.q.size(), 0);
  for (const int cell : cells) own[static_cast<std::size_t>(cell)] = 1;
  cv::convexHull(corners, hull);
  const cv::Rect frame = cv::boundingRect(hull) & cv::Rect(0, 0, patch.side, patch.side);
  int filled = 0, all = 0;
  for (int row = frame.y; row < frame.y + frame.height; ++row) {
    for (int column = frame.x; column < frame.x + frame.width; ++column) {
      const cv::Point2f middle(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
      if (cv::pointPolygonTest(hull, middle, false) < 0.0) continue;
      const auto i = static_cast<std::size_t>(row * patch.side + column);
      if (own[i] == 0 && patch.q[i] > nearest) continue;  // something stands before it
      ++all;
      filled += own[i];
    }
  }
  return all > 0 ? static_cast<double>(filled) / all : 0.0;
}

/// Sizes as the operator gave them, named as they fit best; what is seen stays where it is, and the
/// rest lies behind it.
OrientedBox withSizes(const OrientedBox& seen, const Vector3d& sizes) {
  std::array<int, 3> order{0, 1, 2}, best = order;
  double least = std::numeric_limits<double>::infinity();
  const Vector3d view = seen.centre.normalized();
  do {
    double misfit = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double across = 1.0 - std::abs(view.dot(seen.rotation.col(i)));
      const double size = sizes[order[static_cast<std::size_t>(i)]];
      misfit += (tuning.alongView + across) * std::abs(std::log(size / seen.size[i]));
    }
    if (misfit < least) least = misfit, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  OrientedBox box = seen;
  for (int i = 0; i < 3; ++i) {
    const double size = sizes[best[static_cast<std::size_t>(i)]];
    box.centre +=
        seen.rotation.col(i) * view.dot(seen.rotation.col(i)) * (size - seen.size[i]) / 2.0;
    box.size[i] = size;
  }
  return box;
}

/// The axes of the least volume; column 2 is the candidate it was turned about.
OrientedBox minBox(const std::vector<Vector3d>& points, const std::vector<Vector3d>& normals,
                   double grow) {
  std::optional<OrientedBox> best;
  for (const Vector3d& normal : normals) {
    const OrientedBox box = boxAlong(axesAbout(normal, points), points, grow);
    if (!best || box.size.prod() < best->size.prod()) best = box;
  }
  if (best->rotation.determinant() < 0.0) best->rotation.col(2) *= -1.0;
  return *best;
}

}  // namespace

LoadDetection fitBox(const DepthPatch& patch, const LoadBody& body, double reach,
                     const LoadParameters& parameters) {
  const double toolRadius = parameters.toolSize / 2.0, cell = patch.cell * body.tool.z();
  const std::vector<int> cells = withoutBoom(patch, body, reach, toolRadius);
  std::vector<Vector3d> points;
  std::size_t outside = 0;
  for (const int index : cells) {
    points.push_back(patch.point(index));
    if ((points.back() - body.tool).norm() > toolRadius + cell) ++outside;
  }
  if (outside < tuning.minOutside) return LoadDetection::refused(LoadFault::NoBody);

  std::vector<Vector3d> normals = body.surfaces;
  const Matrix3d principal = principalAxes(points);
  for (int i = 0; i < 3; ++i) normals.emplace_back(principal.col(i));
  const auto face = dominantPlane(patch, cells, cell);
  std::ptrdiff_t onFace = 0;
  if (face) {
    normals.push_back(face->n.normalized());
    onFace = std::count_if(cells.begin(), cells.end(),
                           [&](int index) { return face->holds(patch, index, cell); });
  }
  OrientedBox box = minBox(points, normals, tuning.grow * cell);
  const bool locked = parameters.dimensions == LoadDimensions::Locked;
  const double offFace = 1.0 - static_cast<double>(onFace) / static_cast<double>(cells.size());
  if (offFace < tuning.minOffFace && !locked) return LoadDetection::refused(LoadFault::DepthHidden);
  if (filledShare(box, patch, cells) < tuning.minFilled) {
    return LoadDetection::refused(LoadFault::PoorFit);
  }
  if (locked) box = withSizes(box, {parameters.sizeX, parameters.sizeY, parameters.sizeZ});
  return {box, LoadFault::None, true};
}

}  // namespace boomwatch
