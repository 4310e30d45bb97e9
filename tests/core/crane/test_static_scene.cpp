#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>
#include <QtTest>

#include "cloud/low_pass.h"
#include "crane/static_scene.h"
#include "environment/environment_model.h"
#include "support/test_registry.h"

using boomwatch::Cloud;
using boomwatch::OrientedBox;
using boomwatch::Parameters;
using boomwatch::Points;
using boomwatch::separateStatic;
using boomwatch::StaticScene;
using boomwatch::ToolMask;
using Eigen::Vector3f;

namespace {

constexpr float step = 0.02F;

/// A wall at depth z, a point every 2 cm.
Points wall(float xMin, float xMax, float yMin, float yMax, float z) {
  Points points;
  for (int i = 0; xMin + step * static_cast<float>(i) <= xMax; ++i) {
    for (int j = 0; yMin + step * static_cast<float>(j) <= yMax; ++j) {
      points.emplace_back(xMin + step * static_cast<float>(i), yMin + step * static_cast<float>(j),
                          z);
    }
  }
  return points;
}

Cloud cloudOf(std::initializer_list<Points> parts) {
  Cloud cloud;
  for (const auto& part : parts) cloud.points.insert(cloud.points.end(), part.begin(), part.end());
  cloud.width = static_cast<int>(cloud.size());
  cloud.height = 1;
  return cloud;
}

std::size_t countNear(const Points& points, float z) {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(),
                    [z](const Vector3f& p) { return std::abs(p.z() - z) < 0.05F; }));
}

const Points floorAt5 = wall(-2.0F, 2.0F, -2.0F, 2.0F, 5.0F);
const Points boomAt2 = wall(-0.1F, 0.1F, -2.0F, 0.5F, 2.0F);

}  // namespace

class TestStaticScene : public QObject {
  Q_OBJECT

 private slots:
  void keepsTheSceneWhereNothingIsDynamic() {
    const StaticScene scene = separateStatic(cloudOf({floorAt5, boomAt2}), {}, {}, Parameters{});
    QVERIFY(countNear(scene.statics, 5.0F) > 9000);
    QVERIFY(countNear(scene.statics, 2.0F) > 300);
    QVERIFY(scene.removed.empty() && scene.beyond.empty() && !scene.toolBox);
    QCOMPARE(scene.toolMask, ToolMask::NoToolPoint);
    QVERIFY(scene.noise.empty());
  }

  void leavesOutWhatIsOutsideTheBoundsAndKeepsWhatLiesBehind() {
    Parameters parameters;
    parameters.filter.clusterMinimum = 1;
    const Cloud cloud = cloudOf({{{0, 0, 5},
                                  {11, 0, 5},
                                  {0, -6, 5},
                                  {0, 0, -1},
                                  {1, 1, 20},
                                  {11, 1, 20},
                                  boomwatch::unmeasuredPoint(),
                                  Vector3f::Constant(std::numeric_limits<float>::infinity())}});
    const StaticScene scene = separateStatic(cloud, {}, {}, parameters);
    QCOMPARE(scene.statics, (Points{{0, 0, 5}}));
    QCOMPARE(scene.beyond, (Points{{1, 1, 20}}));
  }

  void theToolsClusterAndNothingElseIsRemoved() {
    const Cloud cloud = cloudOf({floorAt5, boomAt2});
    const StaticScene scene = separateStatic(cloud, Vector3f(0, 0.45F, 2), {}, Parameters{});
    QCOMPARE(scene.toolMask, ToolMask::Taken);
    QCOMPARE(countNear(scene.statics, 2.0F), std::size_t{0});
    QVERIFY(countNear(scene.removed, 2.0F) > 300);
    QCOMPARE(countNear(scene.removed, 5.0F), std::size_t{0});
    QVERIFY(scene.toolBox->contains({0, 0.4, 2.0}));
    QVERIFY((scene.toolBox->max - scene.toolBox->min - Eigen::Vector3d(0.2, 2.5, 0)).norm() < 0.1);
  }

  void aJawBehindTheLoadGoesWithTheToolAndAStoneElsewhereDoesNot() {
    // Both are as far from the tool and hang together with nothing; only one is at the load.
    const Vector3f tool(0, 0.45F, 2);
    const Points jaw = wall(-0.1F, 0.1F, 0.8F, 0.95F, 2.2F);
    const Points stone = wall(0.5F, 0.65F, 0.4F, 0.6F, 2.2F);
    const OrientedBox load{{0, 0.9, 2.0}, {1.0, 0.2, 0.2}};
    const Cloud cloud = cloudOf({floorAt5, boomAt2, jaw, stone});
    const StaticScene scene = separateStatic(cloud, tool, load, Parameters{});
    QCOMPARE(scene.toolMask, ToolMask::Taken);
    QVERIFY(countNear(scene.statics, 2.2F) > 10);
    QVERIFY(countNear(scene.removed, 2.2F) > 10);
    for (const Vector3f& p : scene.statics) QVERIFY(p.z() > 4.0F || p.x() > 0.4F);
    // Without a load nothing says that the jaw is one.
    const StaticScene empty = separateStatic(cloud, tool, {}, Parameters{});
    QCOMPARE(countNear(empty.removed, 2.2F), std::size_t{0});
  }

  void whatTheLoadJoinsWithAJawDoesNotKeepItFromTheTool() {
    // The jaw's points and the load's are one cluster, most of it far from the tool.
    const Vector3f tool(0, 0.45F, 2);
    const Points jaw = wall(-0.1F, 0.1F, 0.8F, 0.95F, 2.2F);
    const Points log = wall(-1.4F, 1.4F, 1.0F, 1.2F, 2.2F);
    const OrientedBox load{{0, 1.1, 2.25}, {2.9, 0.3, 0.3}};
    const StaticScene scene =
        separateStatic(cloudOf({floorAt5, boomAt2, jaw, log}), tool, load, Parameters{});
    QCOMPARE(scene.toolMask, ToolMask::Taken);
    QCOMPARE(countNear(scene.statics, 2.2F), std::size_t{0});
  }

  void aBoomThatIsCutForAMomentIsNoObstacle() {
    const Points lower = wall(-0.1F, 0.1F, -0.4F, 0.5F, 2.0F);
    const Points upper = wall(-0.1F, 0.1F, -2.0F, -0.7F, 2.0F);
    const Points stone = wall(0.8F, 1.0F, -1.2F, -1.0F, 2.0F);
    const Vector3f tool(0, 0.45F, 2);
    boomwatch::CraneMemory memory;
    memory.note(7.0, separateStatic(cloudOf({floorAt5, boomAt2}), tool, {}, {}).toolCluster);
    const Cloud cut = cloudOf({floorAt5, lower, upper, stone});
    QVERIFY(countNear(separateStatic(cut, tool, {}, {}).statics, 2.0F) > 200);
    memory.forgetBefore(7.2);
    const StaticScene scene = separateStatic(cut, tool, {}, {}, memory);
    // Only the stone is left, and what the memory alone took for crane will not be remembered.
    for (const Vector3f& p : scene.statics) QVERIFY(p.z() > 4.0F || p.x() > 0.5F);
    QVERIFY(countNear(scene.statics, 2.0F) > 20);
    for (const Vector3f& p : scene.toolCluster) QVERIFY(p.y() > -0.6F);
    // It does not last, nor outlive a clock that was set back.
    memory.forgetBefore(7.3);
    QVERIFY(countNear(separateStatic(cut, tool, {}, {}, memory).statics, 2.0F) > 200);
    memory.note(7.3, scene.toolCluster);
    QVERIFY(memory.knows(scene.toolCluster.front()));
    memory.forgetBefore(1.0);
    QVERIFY(!memory.knows(scene.toolCluster.front()));
  }

  void aStoneNearerThanTheBoomsCentreIsNotTakenForTheTool() {
    // The centre of the boom is 1.2 m from its end, that of the stone half a metre.
    const Points stone = wall(0.5F, 0.7F, 0.4F, 0.6F, 2.0F);
    const Cloud cloud = cloudOf({floorAt5, boomAt2, stone});
    const StaticScene scene = separateStatic(cloud, Vector3f(0, 0.45F, 2), {}, Parameters{});
    QCOMPARE(scene.toolMask, ToolMask::Taken);
    QVERIFY(scene.toolBox->max.x() < 0.2);
    QVERIFY(countNear(scene.statics, 2.0F) > 20);
  }

  void amongClustersAtTheToolTheNearestCentreWins() {
    const Points grapple = wall(0.25F, 0.45F, 0.4F, 0.6F, 2.0F);
    const Cloud cloud = cloudOf({floorAt5, boomAt2, grapple});
    const StaticScene scene = separateStatic(cloud, Vector3f(0.18F, 0.45F, 2), {}, Parameters{});
    QCOMPARE(scene.toolMask, ToolMask::Taken);
    QVERIFY(scene.toolBox->min.x() > 0.2);
  }

  void nothingIsMaskedWhereNoClusterIsAtTheTool() {
    const Cloud cloud = cloudOf({floorAt5, boomAt2});
    const StaticScene scene = separateStatic(cloud, Vector3f(1, 1, 3), {}, Parameters{});
    QCOMPARE(scene.toolMask, ToolMask::NothingThere);
    QVERIFY(!scene.toolBox && scene.removed.empty());
  }

  void aToolThatTouchesTheGroundDoesNotHideTheScene() {
    const Cloud cloud = cloudOf({floorAt5, boomAt2});
    const StaticScene onFloor = separateStatic(cloud, Vector3f(0, 0, 5), {}, Parameters{});
    QCOMPARE(onFloor.toolMask, ToolMask::TooLarge);
    QVERIFY(!onFloor.toolBox && onFloor.removed.empty());
    QVERIFY(countNear(onFloor.statics, 5.0F) > 9000);
  }

  void everyPointInTheLoadsBoxIsRemoved() {
    OrientedBox load;
    load.centre = {0.5, 0.0, 5.0};
    load.size = {1.0, 0.2, 0.4};
    load.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const StaticScene scene = separateStatic(cloudOf({floorAt5}), {}, load, Parameters{});
    QVERIFY(!scene.removed.empty());
    for (const auto& p : scene.removed) QVERIFY(load.contains(p.cast<double>()));
    for (const auto& p : scene.statics) QVERIFY(!load.contains(p.cast<double>()));
  }

  void smallClustersAreNoiseAndCounted() {
    const Points speck = wall(1.0F, 1.1F, 1.0F, 1.1F, 3.0F);
    const StaticScene scene = separateStatic(cloudOf({floorAt5, speck}), {}, {}, Parameters{});
    QCOMPARE(countNear(scene.statics, 3.0F), std::size_t{0});
    QVERIFY(!scene.noise.empty() && scene.noise.size() < 20);
    QCOMPARE(countNear(scene.noise, 3.0F), scene.noise.size());
  }

  void aSurfaceStaysWholeHoweverCoarseTheResolution_data() {
    QTest::addColumn<double>("resolution");
    for (const double r : {0.04, 0.08, 0.12, 0.2, 0.4}) QTest::addRow("%g m", r) << r;
  }
  void aSurfaceStaysWholeHoweverCoarseTheResolution() {
    QFETCH(double, resolution);
    Parameters parameters;
    parameters.model.resolution = resolution;
    const StaticScene scene = separateStatic(cloudOf({floorAt5}), {}, {}, parameters);
    QVERIFY(scene.noise.empty());
    QVERIFY(countNear(scene.statics, 5.0F) > 80);
  }

  void theRadiusFilterKeepsWhatPclKeeps() {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> side(-0.5F, 0.5F);
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    Points points;
    for (int i = 0; i < 3000; ++i) {
      points.emplace_back(side(random), side(random), side(random));
      cloud->push_back({points.back().x(), points.back().y(), points.back().z()});
    }
    boomwatch::FilterParameters filter;
    filter.lowPassMethod = boomwatch::LowPassMethod::Radius;
    filter.lowPassMinimum = 12;
    Points outliers;
    const Points kept = boomwatch::withoutOutliers(points, filter, outliers);
    pcl::RadiusOutlierRemoval<pcl::PointXYZ> peer;
    peer.setInputCloud(cloud);
    peer.setRadiusSearch(filter.lowPassRadius);
    peer.setMinNeighborsInRadius(filter.lowPassMinimum);
    pcl::PointCloud<pcl::PointXYZ> expected;
    peer.filter(expected);
    QVERIFY(kept.size() > 500 && outliers.size() > 500);
    QCOMPARE(kept.size(), expected.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      QCOMPARE(kept[i], Vector3f(expected[i].getVector3fMap()));
    }
  }

  void zReprojectionFlattensWhatIsKept() {
    Parameters parameters;
    parameters.filter.zReprojection = 3.0;
    const StaticScene scene =
        separateStatic(cloudOf({floorAt5, boomAt2}), Vector3f(0, 0, 2), {}, parameters);
    QCOMPARE(countNear(scene.statics, 3.0F), scene.statics.size());
    QCOMPARE(scene.toolMask, ToolMask::TooLarge);  // flattened, boom and floor are one
  }

  void downsamplingLeavesNoHolesInTheModel() {
    // Points every 2 cm, cells of 4 cm whose rows begin at -5.75: one point a cell, in every cell.
    Parameters parameters;
    const StaticScene scene = separateStatic(cloudOf({floorAt5}), {}, {}, parameters);
    boomwatch::EnvironmentModel model(boomwatch::GridGeometry(parameters.bounds, 0.04));
    for (int frame = 0; frame < 4; ++frame) model.update(scene.statics, parameters.model);
    const auto& grid = model.geometry();
    for (int row = grid.rowOf(-1.9); row < grid.rowOf(1.9); ++row) {
      for (int column = grid.columnOf(-1.9); column < grid.columnOf(1.9); ++column) {
        QCOMPARE(model.state(column, row), boomwatch::CellState::Occupied);
      }
    }
  }

  void lowPassRemovesLonePoints_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("statistical") << int(boomwatch::LowPassMethod::Statistical);
    QTest::newRow("radius") << int(boomwatch::LowPassMethod::Radius);
  }
  void lowPassRemovesLonePoints() {
    QFETCH(int, method);
    Parameters parameters;
    parameters.filter.lowPass = true;
    parameters.filter.lowPassMethod = static_cast<boomwatch::LowPassMethod>(method);
    parameters.filter.lowPassDeviations = 5.0;
    parameters.filter.clusterMinimum = 1;
    const Cloud cloud = cloudOf({floorAt5, {{0, 0, 3}, {1, 1, 2}}});
    const StaticScene scene = separateStatic(cloud, {}, {}, parameters);
    QCOMPARE(countNear(scene.statics, 3.0F) + countNear(scene.statics, 2.0F), std::size_t{0});
    QVERIFY(countNear(scene.statics, 5.0F) > 9000);
    QVERIFY(scene.noise.size() >= 2);
  }

  void lowPassTakesFewerPointsThanItAsksFor() {
    boomwatch::FilterParameters filter;
    filter.lowPassNeighbours = 200;
    for (const auto method :
         {boomwatch::LowPassMethod::Statistical, boomwatch::LowPassMethod::Radius}) {
      filter.lowPassMethod = method;
      Points outliers;
      QVERIFY(boomwatch::withoutOutliers({}, filter, outliers).empty() && outliers.empty());
      for (std::size_t count : {1U, 2U, 3U, 100U}) {
        outliers.clear();
        const Points kept = boomwatch::withoutOutliers(Points(count, {1, 2, 3}), filter, outliers);
        QCOMPARE(kept.size() + outliers.size(), std::size_t{count});
      }
    }
  }

  void takesWhateverAFrameHolds() {
    const float huge = 1e30F;
    const OrientedBox load{{0, 0, 3}, {1, 1, 1}, Eigen::Matrix3d::Identity()};
    for (const Cloud& cloud : {Cloud{}, cloudOf({Points(1000, boomwatch::unmeasuredPoint())}),
                               cloudOf({{{huge, huge, huge}, {-huge, 0, 1}, {0, 0, huge}}}),
                               cloudOf({Points(50'000, {0, 0, 3})})}) {
      for (const Vector3f& tool :
           {Vector3f(0, 0, 3), boomwatch::unmeasuredPoint(), Vector3f(huge, huge, huge)}) {
        const StaticScene scene = separateStatic(cloud, tool, load, Parameters{});
        QVERIFY(scene.statics.empty());
      }
    }
  }
};

BOOMWATCH_TEST(TestStaticScene)
#include "test_static_scene.moc"
