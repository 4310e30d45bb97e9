#include "crane/crane_mask.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "crane/boom_beyond.h"

namespace boomwatch {
namespace {

using Eigen::Vector3f;

/// Where a piece of the tool may be that does not hang together with its cluster, as a grapple's
/// jaw does not that is seen behind the load: in the tool's own size, or somewhat farther than its
/// diameter where that is close to the load (the tool point lies on what is seen of the tool, not
/// in its middle). Nothing is so near to the load and not yet touched, but what hangs together with
/// larger things. The load's own points say nothing about what hangs together with them.
struct HangsAtTool {
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

/// One cluster, as far as it matters for finding the tool.
struct ClusterShape {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3f box;
  float toTool2 = std::numeric_limits<float>::infinity();  ///< nearest point to the tool, squared
  float farthest2 = 0.0F;                                  ///< from the tool, squared
  bool hangsAtTool = true;                                 ///< every point; see HangsAtTool
  int points = 0;
  int known = 0;  ///< where the crane was a moment ago
  Spread spread;

  void add(const Vector3f& p, const Vector3f& tool, const HangsAtTool& hangs) {
    sum += p.cast<double>();
    box.extend(p);
    const float squared = (p - tool).squaredNorm();
    toTool2 = std::min(toTool2, squared);
    farthest2 = std::max(farthest2, squared);
    hangsAtTool = hangsAtTool && hangs(p);
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
  const auto held = std::count_if(points.begin(), points.end(),
                                  [&](const Vector3f& p) { return box.contains(p); });
  const Vector3f sizes = box.sizes();
  return 2 * static_cast<std::size_t>(held) > points.size() ||
         (2 * sizes.x() > bounds.xMax - bounds.xMin && 2 * sizes.y() > bounds.yMax - bounds.yMin);
}

/// The parts of the boom that do not hang together with the tool's in the picture.
void addBoomBeyond(CraneMask& mask, const std::vector<ClusterShape>& shapes, const Points& points,
                   const Clusters& clusters, const Cloud& cloud, const HangsAtTool& tool) {
  std::vector<std::optional<Points>> pieces(shapes.size());  // those that may be a part
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (mask.parts[k] != CranePart::Tool && shapes[k].points > 0 &&
        shapes[k].spread.mayBeStraight()) {
      pieces[k].emplace();
    }
  }
  if (std::ranges::none_of(pieces, [](const auto& piece) { return piece.has_value(); })) return;
  Points seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3f& p = points[i];
    const auto label = static_cast<std::size_t>(clusters.labels[i]);
    if (pieces[label]) pieces[label]->push_back(p);
    const bool isTools = mask.parts[label] == CranePart::Tool;
    if (isTools && !tool.isWithin(p) && !tool.isLoad(p)) seen.push_back(p);
  }
  const BoomBeyond beyond(seen, cloud.camera);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k] && beyond.isPart(*pieces[k])) mask.parts[k] = CranePart::Boom;
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
  constexpr double mostly = 0.6;
  const double loadReach = unseenLoad ? parameters.load.maxSize / 2.0 : 0.0;
  const HangsAtTool hangs{tool, parameters.load.toolSize, load};
  std::vector<ClusterShape> shapes(clusters.sizes.size());
  CraneMask mask{ToolMask::NothingThere, std::nullopt,
                 std::vector<CranePart>(shapes.size(), CranePart::None)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto label = static_cast<std::size_t>(clusters.labels[i]);
    if (clusters.sizes[label] < parameters.filter.clusterMinimum) continue;
    shapes[label].add(points[i], tool, hangs);
    shapes[label].known += memory.knows(points[i]);
  }
  // The tool point is a pixel's; downsampling moved the points around it by up to about R.
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
    if (&shape == nearest || (shape.points > 0 && shape.hangsAtTool)) {
      mask.parts[k] = CranePart::Tool;
    } else if (shape.points > 0 && shape.known > shape.points * mostly) {
      mask.parts[k] = CranePart::Remembered;
    } else if (shape.points > 0 && shape.farthest2 < loadReach * loadReach) {
      mask.parts[k] = CranePart::MaybeLoad;
    }
  }
  // Flattened, a boom has no direction.
  if (!parameters.filter.zReprojection) addBoomBeyond(mask, shapes, points, clusters, cloud, hangs);
  return mask;
}

}  // namespace boomwatch
