#include <QtTest>
#include <limits>

#include "collision/exact_clearance.h"
#include "collision/ray_clearance.h"
#include "support/collision_scenes.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

// Cells of 5 cm, and a level box of 20 x 8 cells whose corners lie on cell centres, so that its
// rays run through centres: corners on columns 30 and 50, rows 26 and 34.
const GridGeometry grid{{-2, 2, -1.5, 1.5, 0, 5}, 0.05};
constexpr int depthLevel = 102;
const double depth = grid.zOf(depthLevel);  // 2 m
const OrientedBox level{{0.025, 0.025, depth}, {1, 0.4, 0.6}};
constexpr int left = 30, right = 50, top = 26, bottom = 34;

EnvironmentModel cellsAt(std::initializer_list<std::array<int, 3>> cells) {
  EnvironmentModel model(grid);
  for (const auto& [column, row, depthOfCell] : cells) {
    model.set(column, row, 0.6F, static_cast<std::uint8_t>(depthOfCell));
  }
  return model;
}

double exactDistance(const EnvironmentModel& model, const OrientedBox& box) {
  ExactClearance exact;
  exact.rebuild(model);
  return exact.query(box, std::numeric_limits<double>::infinity()).nearest->distance;
}

bool close(double a, double b) { return std::abs(a - b) < 1e-9; }

}  // namespace

class TestRayClearance : public QObject {
  Q_OBJECT

 private slots:
  void findsTheFloorBehindALevelBox() {
    const EnvironmentModel model = scenes::flatFloor(grid, 4.0);
    const OrientedBox box{{0, 0, depth}, {1, 0.4, 0.6}};  // no cell centre lies under its edges
    const Clearance found = rayClearance(model, box, 8, 70);
    QVERIFY(found.state == ClearanceState::Measured);
    QVERIFY(close(found.nearest->distance, grid.zOf(grid.levelOf(4.0)) - depth - 0.3));
    QVERIFY(found.nearest->part == LoadPart::Face);
    QVERIFY(close(found.nearest->quantisation, grid.levelStep() / 2));
  }

  void findsWhatHangsBetweenTheCameraAndTheBox() {
    const EnvironmentModel model = cellsAt({{40, 30, 51}});
    const Clearance found = rayClearance(model, level, 8, 70);
    QVERIFY(close(found.nearest->distance, depth - 0.3 - grid.zOf(51)));
  }

  void looksThroughTheTiltedFaceAlongZ() {
    // About y by t: a face at half the thickness h lies h / cos t behind the centre, along z.
    const double t = 0.3;
    const OrientedBox box{
        {grid.xOf(40), grid.yOf(30), 2}, {1, 0.4, 0.3}, rotationFromYawPitchRoll(t, 0, 0)};
    const Clearance found = rayClearance(cellsAt({{40, 30, 200}}), box, 1000, 0);
    QVERIFY(close(found.nearest->distance, grid.zOf(200) - 2 - 0.15 / std::cos(t)));
  }

  void reportsZeroWhenTheEnvironmentIsInsideTheBox() {
    const EnvironmentModel model = cellsAt({{40, 30, depthLevel + 10}});
    const Clearance found = rayClearance(model, level, 8, 70);
    QCOMPARE(found.nearest->distance, 0.0);
    QVERIFY(found.nearest->part == LoadPart::Inside);
    QCOMPARE(found.nearest->onLoad, found.nearest->onEnvironment);
  }

  void reportsZeroWhereATiltedBoxReachesOverItsOutline() {
    // Stood at 45 degrees, half of the box lies beyond the rectangle that carries the corners.
    const OrientedBox box{
        {grid.xOf(40), grid.yOf(30), 2}, {1, 0.4, 1.2}, rotationFromYawPitchRoll(0.7, 0, 0)};
    const Vector3d beyond = box.centre + box.rotation * Vector3d(0.4, 0, 0.5);
    const int column = grid.columnOf(beyond.x()), cellLevel = grid.levelOf(beyond.z());
    const EnvironmentModel model = cellsAt({{column, 26, cellLevel}});
    QVERIFY(box.contains(grid.surfacePoint(column, 26, cellLevel)));
    QVERIFY(beyond.x() > (box.centre + box.rotation * Vector3d(0.5, 0, 0)).x() + 0.1);
    QCOMPARE(rayClearance(model, box, 1, 70).nearest->distance, 0.0);
  }

  void hitsAWallBesideTheBoxWithASideRay() {
    // Side rays leave the right side on rows 26 (m_2) and, if the interval allows, further down.
    for (const int row : {top, top + 4}) {
      const EnvironmentModel model = cellsAt({{right + 10, row, depthLevel}});
      const Clearance found = rayClearance(model, level, 4, 70);
      QVERIFY(close(found.nearest->distance, 0.5));
      QVERIFY(close(found.nearest->quantisation, 0.025));
    }
  }

  void measuresTheDepthBetweenTheRaysStartAndTheWall() {
    const EnvironmentModel model = cellsAt({{left - 6, bottom, depthLevel + 20}});
    const double expected = std::hypot(6 * 0.05, 20 * grid.levelStep());
    QVERIFY(close(rayClearance(model, level, 8, 70).nearest->distance, expected));
  }

  void hitsABlockWithACornerRay() {
    // Off the sides, on the diagonals through the four corners.
    for (const auto& [column, row] : {std::pair{right + 10, bottom + 10},
                                      {left - 10, bottom + 10},
                                      {right + 10, top - 10},
                                      {left - 10, top - 10}}) {
      const Clearance found = rayClearance(cellsAt({{column, row, depthLevel}}), level, 8, 70);
      QVERIFY(found.nearest);
      QVERIFY(close(found.nearest->distance, 10 * 0.05 * std::sqrt(2.0)));
      QVERIFY(found.nearest->part == LoadPart::Edge);
    }
  }

  void missesAThinPoleBetweenTwoRays() {
    const EnvironmentModel model = cellsAt({{left + 3, top - 5, depthLevel}});
    QVERIFY(close(exactDistance(model, level), 0.25));
    QVERIFY(rayClearance(model, level, 8, 70).state == ClearanceState::NothingInRange);
    QVERIFY(close(rayClearance(model, level, 1, 70).nearest->distance, 0.25));
  }

  void startsATiltedBoxsRaysAtTheirOwnDepth() {
    // Turned about y, the box's right end m_2 comes nearer by half its length times sin t.
    const double t = 0.35;
    const OrientedBox box{level.centre, level.size, rotationFromYawPitchRoll(t, 0, 0)};
    const Vector3d corner = level.centre + Vector3d(0.5 * std::cos(t), -0.2, -0.5 * std::sin(t));
    const Vector3d pole = grid.surfacePoint(right + 10, top, depthLevel);
    const EnvironmentModel model = cellsAt({{right + 10, top, depthLevel}});
    const Clearance found = rayClearance(model, box, 8, 70);
    QVERIFY(close(found.nearest->distance, (pole - corner).norm()));
    QVERIFY((found.nearest->onLoad - corner).norm() < 1e-9);
  }

  void seesAsFarAsTheRadiusAndNoFarther() {
    const EnvironmentModel model = cellsAt({{right + 20, top, depthLevel}});
    QVERIFY(close(rayClearance(model, level, 8, 20).nearest->distance, 1.0));
    QVERIFY(rayClearance(model, level, 8, 19).state == ClearanceState::NothingInRange);
  }

  void castsARayEveryIntervalAndOneFromEachCorner() {
    // 20 cells: k I = 0, 8, 16. 8 cells: 0 only (Eq. 15 stops before the next corner).
    const auto rays = rayClearance(EnvironmentModel(grid), level, 8, 10).rays;
    QCOMPARE(rays.size(), 3U + 1U + 3U + 1U + 4U);
    for (const SearchRay& ray : rays) {
      const double cells = (ray.to - ray.from).norm() / 0.05;
      QVERIFY(close(cells, 10) || close(cells, 9));  // Eq. 16: l <= L; Eq. 19: l < L
      QVERIFY(close(ray.from.z(), depth) && close(ray.to.z(), depth));
      QVERIFY(close(std::abs(ray.from.x() - 0.025), 0.5) ||
              close(std::abs(ray.from.y() - 0.025), 0.2));
      QVERIFY((ray.to - level.centre).norm() > (ray.from - level.centre).norm());
    }
  }

  void endsRaysAtTheEdgeOfTheModel() {
    OrientedBox box = level;
    box.centre.x() = grid.bounds().xMax;
    const EnvironmentModel model = scenes::flatFloor(grid, 4.0);
    const Clearance found = rayClearance(model, box, 1, 10000);
    QVERIFY(close(found.nearest->distance, grid.zOf(grid.levelOf(4.0)) - depth - 0.3));
    for (const SearchRay& ray : found.rays) {
      for (const Vector3d& end : {ray.from, ray.to}) {
        QVERIFY(std::abs(end.x()) < 2 + 1e-9 && std::abs(end.y()) < 1.5 + 1e-9);
      }
    }
    box.centre.x() = 50;
    QVERIFY(rayClearance(model, box, 1, 10).state == ClearanceState::NothingInRange);
  }

  void isBoundedByTheGridWhateverTheBoxAndTheRadius() {
    scenes::Random random(5);
    const EnvironmentModel model = scenes::forest(grid, random, 4);
    for (int n = 0; n < 50; ++n) {
      OrientedBox box{Vector3d(0.1, 0.2, 3), Vector3d(1e8, 1e8, 1e8), scenes::anyTurn(random)};
      if (n % 2 == 0) box.centre = 1e8 * Vector3d::Random();
      const Clearance found = rayClearance(model, box, 1, std::numeric_limits<int>::max());
      QVERIFY(found.rays.size() < 4U * (grid.columns() + grid.rows()) * 2);
    }
    const auto dense = rayClearance(model, level, 1, 10000);
    QVERIFY(dense.nearest);
    QCOMPARE(dense.rays.size(), 20U + 8U + 20U + 8U + 4U);
  }

  void isNeverShorterThanTheExactClearance() {
    scenes::Random random(6);
    const GridGeometry geometry({-4, 4, -3, 3, 0, 10}, 0.04);
    const EnvironmentModel model = scenes::forest(geometry, random, 12, 0.1);
    ExactClearance exact;
    exact.rebuild(model);
    int longer = 0;
    for (int n = 0; n < 2000; ++n) {
      const OrientedBox box = scenes::anyLoad(geometry.bounds(), random);
      const auto rays = rayClearance(model, box, 8, 70).nearest;
      if (!rays) continue;
      const double truth = exact.query(box, 100).nearest->distance;
      QVERIFY2(rays->distance >= truth - 1e-9, qPrintable(QString("pose %1").arg(n)));
      QVERIFY((rays->onLoad - box.nearestTo(rays->onLoad)).norm() < 1e-9);
      longer += rays->distance > truth + 0.5;
    }
    QVERIFY(longer > 0);  // the known weakness: the scene is one that shows it
  }

  void moreOrLongerRaysNeverLengthenTheDistance() {
    scenes::Random random(7);
    const EnvironmentModel model = scenes::forest(grid, random, 5, 0.3);
    const auto distance = [&](const OrientedBox& box, int interval, int radius) {
      const auto nearest = rayClearance(model, box, interval, radius).nearest;
      return nearest ? nearest->distance : std::numeric_limits<double>::infinity();
    };
    for (int n = 0; n < 300; ++n) {
      const OrientedBox box = scenes::anyLoad(grid.bounds(), random);
      const double usual = distance(box, 8, 20);
      QVERIFY(distance(box, 4, 20) <= usual);
      QVERIFY(distance(box, 1, 20) <= usual);
      QVERIFY(distance(box, 8, 40) <= usual);
    }
  }

  void worksAtTheSettingsOfTableSix() {
    struct Row {
      double resolution;
      int interval, radius;
    };
    for (const auto& [resolution, interval, radius] :
         {Row{0.02, 8, 70}, {0.03, 8, 70}, {0.05, 8, 70}, {0.02, 8, 100}, {0.02, 5, 70}}) {
      const GridGeometry geometry({-10, 10, -5.75, 5.75, 0, 10}, resolution);
      const EnvironmentModel model = scenes::flatFloor(geometry, 6.0);
      const OrientedBox box{{1, 1, 3}, {2, 0.3, 0.3}, rotationFromYawPitchRoll(0, 0, 0.5)};
      const auto found = rayClearance(model, box, interval, radius);
      QVERIFY(close(found.nearest->distance, exactDistance(model, box)));
      QCOMPARE(found.rays.size(),
               2U * static_cast<std::size_t>(std::ceil(2 / resolution / interval - 1e-9) +
                                             std::ceil(0.3 / resolution / interval - 1e-9)) +
                   4U);
    }
  }

  void acceptsExtremesAndRefusesWhatIsNoBox() {
    const EnvironmentModel model = scenes::flatFloor(grid, 4.0);
    QVERIFY(rayClearance(model, level, 0, -5).nearest);
    QVERIFY(rayClearance(model, {{0, 0, 2}, {0, 0, 0}}, 8, 70).nearest);
    QVERIFY(rayClearance(EnvironmentModel(grid), level, 8, 70).reason == Reason::None);
    for (const double bad : {std::nan(""), HUGE_VAL, 1e300}) {
      OrientedBox box = level;
      box.centre.x() = bad;
      const Clearance found = rayClearance(model, box, 8, 70);
      QVERIFY(found.state == ClearanceState::Unknown && found.reason == Reason::NoLoad);
      QVERIFY(!found.nearest && found.rays.empty());
    }
  }
};

BOOMWATCH_TEST(TestRayClearance)
#include "test_ray_clearance.moc"
