// Exact clearance against FCL's distance from an OcTree to a box, on the same occupied cells, and
// the thesis's rays at the settings of its Table 6.

#include <fcl/fcl.h>
#include <octomap/octomap.h>

#include <memory>
#include <string>
#include <vector>

#include "../core/collision_scenes.h"
#include "benchmark.h"
#include "collision/exact_clearance.h"
#include "collision/observed_share.h"
#include "collision/ray_clearance.h"

namespace {

using namespace boomwatch;
using scenes::Random;
constexpr double unlimited = HUGE_VAL;

GridGeometry thesisGrid(double resolution) { return {{-10, 10, -5.75, 5.75, 0, 10}, resolution}; }

EnvironmentModel forestAt(double resolution) {
  Random random(1);
  return scenes::forest(thesisGrid(resolution), random, 40);
}

std::vector<OrientedBox> loads(int count) {
  Random random(2);
  std::vector<OrientedBox> boxes;
  for (int n = 0; n < count; ++n) boxes.push_back(scenes::anyLoad(Bounds{}, random));
  return boxes;
}

// Median milliseconds over the boxes; each measured on its own.
template <class Query>
double medianQuery(const std::vector<OrientedBox>& boxes, Query&& query) {
  std::size_t next = 0;
  const int runs = static_cast<int>(boxes.size());
  return bench::medianMilliseconds(runs, [&] { query(boxes[next++ % boxes.size()]); });
}

std::shared_ptr<octomap::OcTree> octreeOf(const EnvironmentModel& model) {
  const GridGeometry& g = model.geometry();
  auto tree = std::make_shared<octomap::OcTree>(g.resolution());
  for (int j = 0; j < g.rows(); ++j) {
    for (int i = 0; i < g.columns(); ++i) {
      const int level = model.levels()[g.index(i, j)];
      if (level == 0) continue;
      const Eigen::Vector3d p = g.surfacePoint(i, j, level);
      tree->setNodeValue(p.x(), p.y(), p.z(), tree->getProbHitLog(), true);
    }
  }
  tree->updateInnerOccupancy();
  return tree;
}

double fclDistance(const fcl::CollisionObjectd& tree, const OrientedBox& box) {
  const auto shape = std::make_shared<fcl::Boxd>(box.size.x(), box.size.y(), box.size.z());
  fcl::CollisionObjectd object(shape, box.rotation, box.centre);
  fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  return fcl::distance(&tree, &object, request, result);
}

// How far FCL's answer is off ours, where neither touches, in half diagonals of an octree's cube:
// it measures to cubes about our surface points. Above 1, one of the two is wrong.
double disagreement(const ExactClearance& exact, const fcl::CollisionObjectd& tree,
                    const std::vector<OrientedBox>& boxes, double resolution) {
  double worst = 0;
  for (const auto& box : boxes) {
    const double ours = exact.query(box, unlimited).nearest->distance;
    const double theirs = fclDistance(tree, box);
    if (ours == 0 || theirs <= 0) continue;
    worst = std::max(worst, std::abs(ours - theirs) / (resolution * std::sqrt(3.0)));
  }
  return worst;
}

void againstFcl(double resolution, const std::string& suffix) {
  const EnvironmentModel model = forestAt(resolution);
  ExactClearance exact;
  std::shared_ptr<octomap::OcTree> octree;
  const double rebuild = bench::medianMilliseconds(21, [&] { exact.rebuild(model); });
  const double build = bench::medianMilliseconds(1, [&] { octree = octreeOf(model); });
  const fcl::CollisionObjectd tree(
      std::make_shared<fcl::OcTreed>(std::shared_ptr<const octomap::OcTree>(octree)));
  const double query =
      medianQuery(loads(1000), [&](const auto& box) { exact.query(box, unlimited); });
  const auto few = loads(101);
  const double peer = medianQuery(few, [&](const auto& box) { fclDistance(tree, box); });
  const auto print = [&](const char* name, double value, const char* unit, const char* bar) {
    bench::print((name + suffix).c_str(), value, unit, bar);
  };
  print("clearance_query", query * 1e3, "us", "-");
  print("clearance_query_fcl", peer * 1e3, "us", "-");
  print("clearance_query_ratio", peer / query, "x", ">=30");
  print("clearance_rebuild", rebuild, "ms", "-");
  print("clearance_rebuild_octree", build, "ms", "-");
  print("clearance_rebuild_ratio", build / rebuild, "x", ">=10");
  print("clearance_fcl_disagreement", disagreement(exact, tree, few, resolution), "x", "<=2");
}

void observedShare(double resolution, const std::string& suffix) {
  const EnvironmentModel model = forestAt(resolution);
  ObservedShare share;
  const double rebuild = bench::medianMilliseconds(21, [&] { share.rebuild(model); });
  const double query = medianQuery(loads(200), [&](const auto& box) { share.query(box, 2.0); });
  bench::print(("observed_share_rebuild" + suffix).c_str(), rebuild, "ms", "-");
  bench::print(("observed_share_query_2m" + suffix).c_str(), query * 1e3, "us", "-");
}

// Table 6: resolution, interval, radius, and the thesis's own milliseconds.
void tableSix() {
  struct Row {
    const char* name;
    double resolution;
    int interval, radius;
    const char* bar;
  };
  constexpr Row rows[] = {
      {"rays_r0.01_i8_l70", 0.01, 8, 70, "<=20.46"},
      {"rays_r0.02_i8_l70", 0.02, 8, 70, "<=9.97"},
      {"rays_r0.03_i8_l70", 0.03, 8, 70, "<=7.12"},
      {"rays_r0.05_i8_l70", 0.05, 8, 70, "<=4.33"},
      {"rays_r0.02_i8_l100", 0.02, 8, 100, "<=12.7"},
      {"rays_r0.02_i8_l70_b", 0.02, 8, 70, "<=9.97"},
      {"rays_r0.02_i5_l70", 0.02, 5, 70, "<=8.32"},
  };
  for (const Row& row : rows) {
    const EnvironmentModel model = forestAt(row.resolution);
    const double time = medianQuery(
        loads(101), [&](const auto& box) { rayClearance(model, box, row.interval, row.radius); });
    bench::print(row.name, time, "ms", row.bar);
  }
}

// Of 2000 poses with something within the rays' length, those in which the rays say more than the
// truth: the unsafe direction.
void overEstimates() {
  constexpr int interval = 8, radius = 70;
  const EnvironmentModel model = forestAt(0.04);
  ExactClearance exact;
  exact.rebuild(model);
  std::vector<double> excess;
  int missed = 0;
  for (const auto& box : loads(10000)) {
    if (excess.size() == 2000) break;
    const Clearance truth = exact.query(box, radius * 0.04);
    if (!truth.nearest) continue;
    const auto rays = rayClearance(model, box, interval, radius).nearest;
    missed += !rays;
    excess.push_back(rays ? rays->distance - truth.nearest->distance : HUGE_VAL);
  }
  const auto percentAbove = [&](double limit) {
    const auto above =
        std::count_if(excess.begin(), excess.end(), [&](double e) { return e > limit; });
    return 100.0 * static_cast<double>(above) / static_cast<double>(excess.size());
  };
  bench::print("rays_over_by_10cm", percentAbove(0.1), "%", "-");
  bench::print("rays_over_by_50cm", percentAbove(0.5), "%", "-");
  bench::print("rays_found_nothing", missed, "poses", "-");
  bench::print("rays_never_short", *std::min_element(excess.begin(), excess.end()), "m", ">=0");
}

}  // namespace

int main() {
  againstFcl(0.04, "");
  againstFcl(0.01, "_r0.01");
  observedShare(0.04, "");
  observedShare(0.01, "_r0.01");
  tableSix();
  overEstimates();
  return 0;
}
