#include "sources/map_source.h"

#include <cmath>

#include "base/error.h"
#include "sources/indexed_source.h"
#include "sources/surface_map.h"

namespace boomwatch {
namespace {

constexpr double maxPoints = 4e6;

/// z at a place given in cells, from the middles of the four around it; NaN where one is unknown.
/// Beyond the outermost middles the outermost cells go on.
float interpolated(const cv::Mat& z, double atColumn, double atRow) {
  const double u = std::clamp(atColumn - 0.5, 0.0, z.cols - 1.0);
  const double v = std::clamp(atRow - 0.5, 0.0, z.rows - 1.0);
  const int i = std::min(static_cast<int>(u), std::max(z.cols - 2, 0));
  const int j = std::min(static_cast<int>(v), std::max(z.rows - 2, 0));
  const int right = std::min(i + 1, z.cols - 1), below = std::min(j + 1, z.rows - 1);
  float sum = 0.0F;
  const auto add = [&](int row, int column, double weight) {
    // What has no weight need not be known.
    if (weight > 0.0) sum += static_cast<float>(weight) * z.at<float>(row, column);
  };
  add(j, i, (1 - u + i) * (1 - v + j));
  add(j, right, (u - i) * (1 - v + j));
  add(below, i, (1 - u + i) * (v - j));
  add(below, right, (u - i) * (v - j));
  return sum;
}

std::shared_ptr<const Cloud> cloudOf(const SurfaceMap& map, const std::string& name) {
  const double step = std::min(map.spacing, map.cell);
  const double columns = std::ceil(map.z.cols * map.cell / step);
  const double rows = std::ceil(map.z.rows * map.cell / step);
  if (columns * rows > maxPoints) {
    throw Error(name,
                "the map would take " + std::to_string(columns * rows / 1e6) +
                    " million points, more than 4",
                "Describe it in a YAML file with a larger 'spacing', or cut the map.");
  }
  auto cloud = std::make_shared<Cloud>();
  cloud->width = static_cast<int>(columns);
  cloud->height = static_cast<int>(rows);
  cloud->points.reserve(static_cast<std::size_t>(columns * rows));
  for (int row = 0; row < cloud->height; ++row) {
    for (int column = 0; column < cloud->width; ++column) {
      const double x = (column + 0.5) * step, y = (row + 0.5) * step;
      const float z = interpolated(map.z, x / map.cell, y / map.cell);
      const Eigen::Vector3f point(static_cast<float>(map.left + x), static_cast<float>(map.top + y),
                                  z);
      cloud->points.push_back(std::isfinite(z) ? point : unmeasuredPoint());
    }
  }
  return cloud;
}

class MapSource : public IndexedSource {
 public:
  MapSource(std::string address, std::shared_ptr<const Cloud> cloud)
      : IndexedSource(std::move(address), 1, 10.0), m_cloud(std::move(cloud)) {}

 private:
  ReadResult read(std::size_t) override {
    auto frame = std::make_shared<Frame>();
    frame->cloud = m_cloud;
    return ok(std::move(frame));
  }

  std::shared_ptr<const Cloud> m_cloud;
};

}  // namespace

std::unique_ptr<FrameSource> openMapSource(const std::filesystem::path& file,
                                           const std::string& address) {
  if (file.empty()) {
    throw Error(address, "no file is given", "Give map:FILE.asc or map:FILE.yaml.");
  }
  return std::make_unique<MapSource>(address, cloudOf(readSurfaceMap(file), file.string()));
}

}  // namespace boomwatch
