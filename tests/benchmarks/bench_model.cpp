// The model's update against the memory it has to touch, and against OctoMap's insertion.
#include <octomap/octomap.h>

#include <random>

#include "benchmark.h"
#include "environment/environment_model.h"

using boomwatch::EnvironmentModel;
using boomwatch::GridGeometry;
using boomwatch::Points;
namespace bench = boomwatch::bench;

namespace {

constexpr int width = 768;
constexpr int height = 576;

/// What a stereo camera with a focal length of 700 px sees of a slanted floor with noise: some
/// points beyond the bounds, every tenth pixel unmeasured.
Points organisedCloud() {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0.0F, 0.01F);
  std::uniform_int_distribution<int> tenth(0, 9);
  Points points;
  points.reserve(width * height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const float z = 11.0F - 6.0F * static_cast<float>(v) / height + noise(random);
      const Eigen::Vector3f ray((static_cast<float>(u) - width / 2.0F) / 700.0F,
                                (static_cast<float>(v) - height / 2.0F) / 700.0F, 1.0F);
      points.push_back(tenth(random) == 0 ? boomwatch::unmeasuredPoint()
                                          : Eigen::Vector3f(z * ray));
    }
  }
  return points;
}

/// Bytes a millisecond that one thread reads and writes back, in an array that no cache holds.
double memoryBandwidth() {
  std::vector<std::uint32_t> memory(64'000'000, 1);
  const double pass = bench::medianMilliseconds(9, [&] {
    for (std::uint32_t& word : memory) ++word;
  });
  return 2.0 * sizeof(std::uint32_t) * static_cast<double>(memory.size()) / pass;
}

/// Bytes moved when the cloud is read once, and the grid read once and written once.
double bytesToTouch(const Points& points, const GridGeometry& grid) {
  return static_cast<double>(points.size() * sizeof(Eigen::Vector3f)) +
         2.0 * GridGeometry::bytesPerCell * static_cast<double>(grid.cellCount());
}

}  // namespace

int main() {
  const Points points = organisedCloud();
  const GridGeometry geometry(boomwatch::Bounds{}, 0.01);
  const double bandwidth = memoryBandwidth();
  const double memory = bytesToTouch(points, geometry) / bandwidth;
  constexpr int frames = 201;  // of a millisecond or two: a neighbour on the machine shows
  const auto timeOf = [&](boomwatch::ModelUpdate kind) {
    EnvironmentModel model(geometry);
    return bench::medianMilliseconds(frames, [&] { model.update(points, {.update = kind}); });
  };
  const double thesis = timeOf(boomwatch::ModelUpdate::Thesis);
  const double hysteresis = timeOf(boomwatch::ModelUpdate::Hysteresis);
  const double logOdds = timeOf(boomwatch::ModelUpdate::LogOdds);
  bench::print("memory_bandwidth", bandwidth / 1e6, "GB/s", "-");
  bench::print("model_memory_time", memory, "ms", "-");
  bench::print("model_update", hysteresis, "ms", "-");
  bench::print("model_update_thesis_ratio", thesis / memory, "x", "<=3");
  bench::print("model_update_hysteresis_ratio", hysteresis / memory, "x", "<=3");
  bench::print("model_update_log_odds_ratio", logOdds / memory, "x", "<=3");

  octomap::Pointcloud cloud;
  for (const auto& p : points) {
    if (boomwatch::isMeasured(p)) cloud.push_back(p.x(), p.y(), p.z());
  }
  octomap::OcTree tree(0.04);
  const double octree = bench::medianMilliseconds(
      1, [&] { tree.insertPointCloud(cloud, octomap::point3d(0, 0, 0)); });
  EnvironmentModel coarse(GridGeometry(boomwatch::Bounds{}, 0.04));
  const double flat =
      bench::medianMilliseconds(51, [&] { coarse.update(points, boomwatch::ModelParameters{}); });
  bench::print("octomap_insertion_4cm", octree, "ms", "-");
  bench::print("model_update_4cm", flat, "ms", "-");
  bench::print("octomap_over_model_4cm", octree / flat, "x", "-");
  return 0;
}
