#include "environment/static_scene.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "environment/clusters.h"
#include "environment/low_pass.h"
#include "environment/voxel_grid.h"

namespace boomwatch {
namespace {

using Eigen::Vector3f;

/// Sorts the measured points into those inside the bounds and those behind them: on their way along
/// z or, in perspective, along their ray.
void crop(const Cloud& cloud, const Bounds& bounds, ModelProjection projection, Points& inside,
          Points& beyond) {
  const bool perspective = projection == ModelProjection::Perspective;
  inside.reserve(cloud.size());
  for (const Vector3f& p : cloud.points) {
    if (!isMeasured(p)) continue;
    if (bounds.contains(p)) {
      inside.push_back(p);
    } else if (perspective
                   ? p.z() > bounds.zMin
                   : p.z() > bounds.zMax && bounds.contains({p.x(), p.y(), float(bounds.zMin)})) {
      beyond.push_back(p);
    }
  }
}

/// Where a piece of the tool may be that does not hang together with its cluster, as a grapple's
/// jaw does not that is seen behind the load: in the tool's own size, or somewhat farther than its
/// diameter where that is close to the load (the tool point lies on what is seen of the tool, not
/// in its middle). Nothing is so near to the load and not yet touched, but what hangs together with
/// larger things. The load's own points say nothing about what hangs together with them.
struct HangsAtTool {
  Vector3f tool;
  double size;  ///< diameter of the tool
  std::optional<OrientedBox> load;

  bool operator()(const Vector3f& p) const {
    constexpr double closeToLoad = 0.3, beyond = 1.3;
    const double away = (p - tool).cast<double>().norm();
    if (away <= size / 2) return true;
    if (!load) return false;
    const Eigen::Vector3d point = p.cast<double>();
    const double toLoad = (load->nearestTo(point) - point).norm();
    return toLoad == 0.0 || (away <= beyond * size && toLoad <= closeToLoad);
  }
};

/// One cluster, as far as it matters for finding the tool.
struct ClusterShape {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3f box;
  float toTool2 = std::numeric_limits<float>::infinity();  ///< nearest point to the tool, squared
  bool hangsAtTool = true;                                 ///< every point; see HangsAtTool
  int points = 0;
  int known = 0;  ///< where the crane was a moment ago

  void add(const Vector3f& p, const Vector3f& tool, const HangsAtTool& hangs) {
    sum += p.cast<double>();
    box.extend(p);
    const float squared = (p - tool).squaredNorm();
    toTool2 = std::min(toTool2, squared);
    hangsAtTool = hangsAtTool && hangs(p);
    ++points;
  }
  double centreTo(const Vector3f& tool) const {
    return (sum / points - tool.cast<double>()).norm();
  }
};

const ClusterShape* nearestAtTool(const std::vector<ClusterShape>& shapes, const Vector3f& tool,
                                  double reach) {
  const ClusterShape* best = nullptr;
  for (const ClusterShape& shape : shapes) {
    if (shape.points == 0 || !(shape.toTool2 <= reach * reach)) continue;
    if (best == nullptr || shape.centreTo(tool) < best->centreTo(tool)) best = &shape;
  }
  return best;
}

bool swallowsScene(const Eigen::AlignedBox3f& box, const Points& points, const Bounds& bounds) {
  const auto held = std::count_if(points.begin(), points.end(),
                                  [&](const Vector3f& p) { return box.contains(p); });
  const Vector3f sizes = box.sizes();
  return 2 * static_cast<std::size_t>(held) > points.size() ||
         (2 * sizes.x() > bounds.xMax - bounds.xMin && 2 * sizes.y() > bounds.yMax - bounds.yMin);
}

enum class Part { Scene, Tool, Crane };  ///< Crane: by memory only

/// Finds the tool's box among the clusters of `points`, whose labels fit them. Returns which of
/// them are the tool: its cluster, and what hangs within its size in pieces of its own, as a
/// grapple's jaw does that is seen behind the load; and which were a part of it a moment ago.
std::vector<Part> maskTool(StaticScene& scene, const Points& points, const Clusters& clusters,
                           const Vector3f& tool, const std::optional<OrientedBox>& load,
                           const Parameters& parameters, const CraneMemory& memory) {
  constexpr double mostly = 0.6;
  const HangsAtTool hangs{tool, parameters.load.toolSize, load};
  std::vector<ClusterShape> shapes(clusters.sizes.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto label = static_cast<std::size_t>(clusters.labels[i]);
    if (clusters.sizes[label] < parameters.filter.clusterMinimum) continue;
    shapes[label].add(points[i], tool, hangs);
    shapes[label].known += memory.knows(points[i]);
  }
  // The tool point is a pixel's; downsampling moved the points around it by up to about R.
  const double reach = parameters.filter.clusterTolerance + parameters.model.resolution;
  const ClusterShape* const found = nearestAtTool(shapes, tool, reach);
  std::vector<Part> parts(shapes.size(), Part::Scene);
  if (found == nullptr) {
    scene.toolMask = ToolMask::NothingThere;
    return parts;
  }
  if (swallowsScene(found->box, points, parameters.bounds)) {
    scene.toolMask = ToolMask::TooLarge;
    return parts;
  }
  scene.toolMask = ToolMask::Taken;
  scene.toolBox = {found->box.min().cast<double>(), found->box.max().cast<double>()};
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const ClusterShape& shape = shapes[k];
    if (&shape == found || (shape.points > 0 && shape.hangsAtTool)) {
      parts[k] = Part::Tool;
    } else if (shape.points > 0 && shape.known > shape.points * mostly) {
      parts[k] = Part::Crane;
    }
  }
  return parts;
}

}  // namespace

std::string_view nameOf(ToolMask mask) {
  switch (mask) {
    case ToolMask::NoToolPoint:
      return "no_tool_point";
    case ToolMask::NothingThere:
      return "nothing_there";
    case ToolMask::TooLarge:
      return "too_large";
    case ToolMask::Taken:
      return "taken";
  }
  return "";
}

StaticScene separateStatic(const Cloud& cloud, const std::optional<Vector3f>& tool,
                           const std::optional<OrientedBox>& load, const Parameters& parameters,
                           const CraneMemory& memory) {
  const FilterParameters& filter = parameters.filter;
  const Bounds& bounds = parameters.bounds;
  StaticScene scene;
  Points points;
  crop(cloud, bounds, parameters.model.projection, points, scene.beyond);

  const auto reprojected = [&](Vector3f p) {
    if (filter.zReprojection) p.z() = static_cast<float>(*filter.zReprojection);
    return p;
  };
  std::transform(points.begin(), points.end(), points.begin(), reprojected);
  const Eigen::Vector3d corner(bounds.xMin, bounds.yMin, bounds.zMin);
  points = voxelCentroids(points, parameters.model.resolution, corner.cast<float>());
  if (filter.lowPass) points = withoutOutliers(points, filter, scene.noise);

  const double tolerance = std::max(filter.clusterTolerance, 2.0 * parameters.model.resolution);
  const Clusters clusters = euclideanClusters(points, static_cast<float>(tolerance));
  std::vector<Part> parts(clusters.sizes.size(), Part::Scene);
  if (tool) parts = maskTool(scene, points, clusters, reprojected(*tool), load, parameters, memory);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto label = static_cast<std::size_t>(clusters.labels[i]);
    if (clusters.sizes[label] < filter.clusterMinimum) {
      scene.noise.push_back(points[i]);
      continue;
    }
    const Eigen::Vector3d p = points[i].cast<double>();
    const bool isLoad = load && load->contains(p);
    if (parts[label] == Part::Tool && !isLoad) scene.toolCluster.push_back(points[i]);
    const bool dynamic =
        parts[label] != Part::Scene || (scene.toolBox && scene.toolBox->contains(p)) || isLoad;
    (dynamic ? scene.removed : scene.statics).push_back(points[i]);
  }
  return scene;
}

}  // namespace boomwatch
