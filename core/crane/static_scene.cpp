#include "crane/static_scene.h"

#include <algorithm>

namespace boomwatch {
namespace {

using Eigen::Vector3f;

/// Moves the points of the load to `removed`.
void removeLoad(const ViewedBox& load, Points& points, Points& removed) {
  std::erase_if(points, [&](const Vector3f& p) {
    const bool isLoad = load.contains(p.cast<double>());
    if (isLoad) removed.push_back(p);
    return isLoad;
  });
}

}  // namespace

StaticScene separateStatic(SegmentedCloud segments, const Cloud& cloud,
                           const std::optional<Vector3f>& tool,
                           const std::optional<ViewedBox>& load, const Parameters& parameters,
                           const CraneMemory& memory, bool unseenLoad) {
  Points& points = segments.points;
  Clusters& clusters = segments.clusters;
  StaticScene scene;
  scene.beyond = std::move(segments.beyond);
  scene.noise = std::move(segments.noise);
  CraneMask crane;
  if (tool) {
    const Vector3f at = reprojected(*tool, parameters.filter);
    crane = craneMask(points, clusters, cloud, at, load, parameters, memory, unseenLoad);
    if (crane.state == ToolMask::TooLarge && load) {
      // A load on the ground may connect the tool to the ground.
      removeLoad(*load, points, scene.removed);
      clusters = clustersOf(points, parameters);
      crane = craneMask(points, clusters, cloud, at, load, parameters, memory, unseenLoad);
    }
  }
  scene.toolMask = crane.state;
  scene.toolBox = crane.toolBox;
  crane.parts.resize(clusters.sizes.size(), CranePart::None);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto label = static_cast<std::size_t>(clusters.labels[i]);
    if (clusters.sizes[label] < parameters.filter.clusterMinimum) {
      scene.noise.push_back(points[i]);
      continue;
    }
    const Eigen::Vector3d p = points[i].cast<double>();
    const bool isLoad = load && load->contains(p);
    const CranePart part = crane.parts[label];
    if (part == CranePart::Tool && !isLoad) scene.toolCluster.push_back(points[i]);
    if (part == CranePart::Boom && !isLoad) scene.boomCut.push_back(points[i]);
    scene.maybeLoad += part == CranePart::MaybeLoad ? 1 : 0;
    const bool dynamic =
        part != CranePart::None || (scene.toolBox && scene.toolBox->contains(p)) || isLoad;
    (dynamic ? scene.removed : scene.statics).push_back(points[i]);
  }
  return scene;
}

}  // namespace boomwatch
