#include <pcl/filters/voxel_grid.h>

#include <QtTest>
#include <random>

#include "cloud/voxel_grid.h"
#include "environment/grid_geometry.h"
#include "support/test_registry.h"

using boomwatch::Points;
using Eigen::Vector3f;

namespace {

Points centroidsOfPcl(const Points& points, float leaf) {
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const auto& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(cloud);
  filter.setLeafSize(leaf, leaf, leaf);
  pcl::PointCloud<pcl::PointXYZ> output;
  filter.filter(output);
  Points result;
  for (const auto& p : output) result.emplace_back(p.x, p.y, p.z);
  return result;
}

/// In order of voxels, so that two lists of centroids can be compared one by one.
Points inOrderOfVoxels(Points points, float leaf) {
  const auto key = [leaf](const Vector3f& p) {
    return std::array{std::floor(p.z() / leaf), std::floor(p.y() / leaf), std::floor(p.x() / leaf),
                      p.z()};
  };
  std::sort(points.begin(), points.end(),
            [&](const Vector3f& a, const Vector3f& b) { return key(a) < key(b); });
  return points;
}

Points randomPoints(std::size_t count, float extent) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(-extent, extent);
  Points points;
  while (points.size() < count) {
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  return points;
}

}  // namespace

class TestVoxelGrid : public QObject {
  Q_OBJECT

 private slots:
  void centroidsAreThoseOfPcl_data() {
    QTest::addColumn<float>("leaf");
    for (const float leaf : {0.04F, 0.1F, 0.25F, 1.0F, 3.0F}) {
      QTest::addRow("%g m", double(leaf)) << leaf;
    }
  }
  void centroidsAreThoseOfPcl() {
    QFETCH(float, leaf);
    const Points points = randomPoints(50'000, 2.0F);
    const Points ours =
        inOrderOfVoxels(boomwatch::voxelCentroids(points, leaf, Vector3f::Zero()), leaf);
    const Points theirs = inOrderOfVoxels(centroidsOfPcl(points, leaf), leaf);
    QCOMPARE(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      QVERIFY((ours[i] - theirs[i]).norm() < 1e-4F);
    }
  }

  void aCentroidStaysInTheColumnOfItsPoints() {
    // -5.75 is no multiple of 0.04: voxels that begin at 0 would straddle the model's rows.
    const boomwatch::GridGeometry grid(boomwatch::Bounds{}, 0.04);
    const Vector3f origin(-10.0F, -5.75F, 0.0F);
    for (int row = 100; row < 180; ++row) {
      for (int column = 200; column < 280; ++column) {
        Points points;
        for (const double part : {0.1, 0.4, 0.9}) {
          points.emplace_back(grid.xOf(column) + (part - 0.5) * 0.04,
                              grid.yOf(row) + (0.5 - part) * 0.04, 5.01);
        }
        const Points centroids = boomwatch::voxelCentroids(points, 0.04, origin);
        QCOMPARE(centroids.size(), std::size_t{1});
        QCOMPARE(grid.columnOf(centroids.front().x()), column);
        QCOMPARE(grid.rowOf(centroids.front().y()), row);
      }
    }
  }

  void takesHugeAndTinyCoordinates() {
    const Points points{
        {3e38F, -3e38F, 0}, {1e30F, 0, 0}, {-1e-40F, 0, 0}, {0, 0, 0}, {-0.0F, 0, 0}};
    const Points centroids = boomwatch::voxelCentroids(points, 0.001, Vector3f::Zero());
    // The tiny negative number is a neighbour of zero; zero and minus zero are one.
    QVERIFY(centroids.size() == 3 || centroids.size() == 4);
    QVERIFY(std::all_of(centroids.begin(), centroids.end(), boomwatch::isMeasured));
    QVERIFY(boomwatch::voxelCentroids({}, 0.04, Vector3f::Zero()).empty());
  }

  void aSmallLeafOnAWideCloudDoesNotOverflow() {
    // pcl::VoxelGrid gives up here: 2e13 leaves do not fit its 32-bit index.
    const Points points = randomPoints(100'000, 10.0F);
    QCOMPARE(boomwatch::voxelCentroids(points, 0.00075, Vector3f::Zero()).size(), points.size());
  }
};

BOOMWATCH_TEST(TestVoxelGrid)
#include "test_voxel_grid.moc"
