#include "crane/crane_mask.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "crane/boom_beyond.h"

namespace boomwatch {
namespace {

using Eigen::Vector3f;

/// The region in which a separate cluster still belongs to the tool, such as a grapple's jaw that
/// is visible behind the load. The region is the tool's own size, and close to the load somewhat
/// more: the tool point lies on the visible side of the tool, not in its middle. An obstacle this
/// near to the load belongs to a larger cluster, which does not lie wholly in the region. Points of
/// the load are always in the region.
struct ToolRegion {
  Vector3f tool;
  double size;  ///< diameter of the tool
  std::optional<ViewedBox> load;

  bool isWithin(const Vector3f& p) const { return (p - tool).norm() <= size / 2; }
  bool isLoad(const Vector3f& p) const { return load && load->contains(p.cast<double>()); }
  bool operator()(const Vector3f& p) const {
    constexpr double closeToLoad = 0.3, beyond = 1.3;
    if (isWithin(p) || isLoad(p)) return true;
    if (!load) return false;
    const double away = (p - tool).cast<double>().norm();
    const Eigen::Vector3d point = p.cast<double>();
    const double toLoad = (load->box.nearestTo(point) - point).norm();
    return away <= beyond * size && toLoad <= closeToLoad;
  }
};

/// The properties of one cluster that decide its part.
struct ClusterShape {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3f box;
  float toTool2 = std::numeric_limits<float>::infinity();  ///< nearest point to the tool, squared
  float farthest2 = 0.0F;                                  ///< from the tool, squared
  bool isAtTool = true;                                    ///< every point is in the ToolRegion
  int points = 0;
  int remembered = 0;  ///< points where the crane was a moment ago
  Spread spread;

  void add(const Vector3f& p, const Vector3f& tool, const ToolRegion& region) {
    sum += p.cast<double>();
    box.extend(p);
    const float squared = (p - tool).squaredNorm();
    toTool2 = std::min(toTool2, squared);
    farthest2 = std::max(farthest2, squared);
    isAtTool = isAtTool && region(p);
    spread.add(p);
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
  const auto inside = std::count_if(points.begin(), points.end(),
                                    [&](const Vector3f& p) { return box.contains(p); });
  const Vector3f sizes = box.sizes();
  return 2 * static_cast<std::size_t>(inside) > points.size() ||
         (2 * sizes.x() > bounds.xMax - bounds.xMin && 2 * sizes.y() > bounds.yMax - bounds.yMin);
}

/// Marks the clusters of the boom that are not connected to the tool.
void addBoomBeyond(CraneMask& mask, const std::vector<ClusterShape>& shapes, const Points& points,
                   const Clusters& clusters, const Cloud& cloud, const ToolRegion& tool) {
  std::vector<std::optional<Points>> candidates(shapes.size());
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (mask.parts[k] != CranePart::Tool && shapes[k].points > 0 &&
        shapes[k].spread.mayBeStraight()) {
      candidates[k].emplace();
    }
  }
  const auto isSet = [](const auto& candidate) { return candidate.has_value(); };
  if (std::ranges::none_of(candidates, isSet)) return;
  Points seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3f& p = points[i];
    const auto label = static_cast<std::size_t>(clusters.labels[i]);
    if (candidates[label]) candidates[label]->push_back(p);
    const bool isTools = mask.parts[label] == CranePart::Tool;
    if (isTools && !tool.isWithin(p) && !tool.isLoad(p)) seen.push_back(p);
  }
  const BoomBeyond beyond(seen, cloud.camera);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (candidates[k] && beyond.isPart(*candidates[k])) mask.parts[k] = CranePart::Boom;
  }
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

CraneMask craneMask(const Points& points, const Clusters& clusters, const Cloud& cloud,
                    const Vector3f& tool, const std::optional<ViewedBox>& load,
                    const Parameters& parameters, const CraneMemory& memory, bool unseenLoad) {
  constexpr double minRemembered = 0.6;  // share of the points
  const double loadReach = unseenLoad ? parameters.load.maxSize / 2.0 : 0.0;
  const ToolRegion region{tool, parameters.load.toolSize, load};
  std::vector<ClusterShape> shapes(clusters.sizes.size());
  CraneMask mask{ToolMask::NothingThere, std::nullopt,
                 std::vector<CranePart>(shapes.size(), CranePart::None)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto label = static_cast<std::size_t>(clusters.labels[i]);
    if (clusters.sizes[label] < parameters.filter.clusterMinimum) continue;
    shapes[label].add(points[i], tool, region);
    shapes[label].remembered += memory.knows(points[i]);
  }
  // The tool point comes from a pixel, and downsampling moved the points around it by about R.
  const double reach = parameters.filter.clusterTolerance + parameters.model.resolution;
  const ClusterShape* const nearest = nearestAtTool(shapes, tool, reach);
  if (nearest == nullptr) return mask;
  if (swallowsScene(nearest->box, points, parameters.bounds)) {
    mask.state = ToolMask::TooLarge;
    return mask;
  }
  mask.state = ToolMask::Taken;
  mask.toolBox = {nearest->box.min().cast<double>(), nearest->box.max().cast<double>()};
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const ClusterShape& shape = shapes[k];
    if (&shape == nearest || (shape.points > 0 && shape.isAtTool)) {
      mask.parts[k] = CranePart::Tool;
    } else if (shape.points > 0 && shape.remembered > shape.points * minRemembered) {
      mask.parts[k] = CranePart::Remembered;
    } else if (shape.points > 0 && shape.farthest2 < loadReach * loadReach) {
      mask.parts[k] = CranePart::MaybeLoad;
    }
  }
  // Reprojection to one depth flattens the boom, so its axis is unknown.
  if (!parameters.filter.zReprojection)
    addBoomBeyond(mask, shapes, points, clusters, cloud, region);
  return mask;
}

}  // namespace boomwatch
