#include <QtTest>
#include <limits>

#include "collision/exact_clearance.h"
#include "collision/search_target.h"
#include "support/collision_scenes.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

/// The distance from a box to a line, from many places on it: no more than a step too long.
double sampledDistance(const OrientedBox& box, const Vector3d& a, const Vector3d& b, int steps) {
  double best = std::numeric_limits<double>::infinity();
  for (int n = 0; n <= steps; ++n) {
    const Vector3d p = a + (b - a) * n / steps;
    best = std::min(best, (p - box.nearestTo(p)).norm());
  }
  return best;
}

/// Every cell that is not free, one after the other: the truth that the search has to equal.
double everyLine(const EnvironmentModel& model, const OrientedBox& box) {
  const GridGeometry& g = model.geometry();
  const SearchTarget target(box);
  double best = std::numeric_limits<double>::infinity();
  for (int j = 0; j < g.rows(); ++j) {
    for (int i = 0; i < g.columns(); ++i) {
      if (model.state(i, j) == CellState::ObservedFree) continue;
      const int level = std::max<int>(model.levels()[g.index(i, j)], 1);
      const Vector3d a = g.surfacePoint(i, j, level), b = g.surfacePoint(i, j, 255);
      const Vector3d p = target.nearestOnLine(a, b);
      best = std::min(best, (p - box.nearestTo(p)).norm());
    }
  }
  return best;
}

}  // namespace

class TestUnseenSpace : public QObject {
  Q_OBJECT
 private slots:
  void theNearestPlaceOnALineIsNoFartherThanAnyOther();
  void equalsEveryLine_data();
  void equalsEveryLine();
  void aCellThatWasNeverSeenIsAnObstacle();
  void behindASurfaceIsSolid();
  void exemptCellsAreFree();
};

void TestUnseenSpace::theNearestPlaceOnALineIsNoFartherThanAnyOther() {
  scenes::Random random(5);
  const Bounds bounds{-2, 2, -2, 2, 0, 5};
  for (int n = 0; n < 2000; ++n) {
    const OrientedBox box = scenes::anyLoad(bounds, random);
    const Vector3d a(scenes::uniform(random, -3, 3), scenes::uniform(random, -3, 3), 0.5);
    const Vector3d b = n % 3 == 0 ? Vector3d(a.x(), a.y(), 5.0)
                                  : Vector3d(scenes::uniform(random, -3, 3), 1.0, 4.0);
    const Vector3d p = SearchTarget(box).nearestOnLine(a, b);
    QVERIFY((p - a).cross(b - a).norm() < 1e-9);
    QVERIFY((p - a).dot(b - a) >= -1e-12 && (p - b).dot(a - b) >= -1e-12);
    const double found = (p - box.nearestTo(p)).norm();
    const double sampled = sampledDistance(box, a, b, 1000);
    QVERIFY(found <= sampled + 1e-9);
    QVERIFY(found >= sampled - (b - a).norm() / 1000);
  }
}

void TestUnseenSpace::equalsEveryLine_data() {
  QTest::addColumn<bool>("perspective");
  QTest::newRow("parallel") << false;
  QTest::newRow("perspective") << true;
}

void TestUnseenSpace::equalsEveryLine() {
  QFETCH(bool, perspective);
  scenes::Random random(6);
  const GridGeometry geometry(
      {-2, 2, -1.5, 1.5, 0, 10}, 0.08,
      perspective ? ModelProjection::Perspective : ModelProjection::Parallel);
  for (const double holes : {0.0, 0.01, 0.4}) {
    EnvironmentModel model = scenes::forest(geometry, random, 4, holes);
    for (int j = 0; j < geometry.rows(); ++j) {  // most is looked through
      for (int i = 0; i < geometry.columns(); ++i) {
        if (scenes::uniform(random, 0, 1) < 0.9) model.set(i, j, 0.1F, 0);
      }
    }
    ExactClearance exact;
    exact.rebuild(model, {}, true);
    for (int n = 0; n < 300; ++n) {
      const OrientedBox box = scenes::anyLoad(geometry.bounds(), random);
      const Clearance found = exact.query(box, std::numeric_limits<double>::infinity());
      QVERIFY(found.nearest);
      BW_COMPARE_NEAR(found.nearest->distance, everyLine(model, box), 1e-9);
    }
  }
}

void TestUnseenSpace::aCellThatWasNeverSeenIsAnObstacle() {
  const GridGeometry geometry({-2, 2, -1.5, 1.5, 0, 5}, 0.05);
  EnvironmentModel model(geometry);
  for (int j = 0; j < geometry.rows(); ++j) {
    for (int i = 0; i < geometry.columns(); ++i) {
      if (geometry.xOf(i) < 1.0) model.set(i, j, 0.1F, 0);
    }
  }
  const OrientedBox box{{0, 0, 2.5}, {0.4, 0.4, 0.4}};
  ExactClearance exact;
  exact.rebuild(model);
  QVERIFY(exact.query(box, 10.0).state == ClearanceState::NothingInRange);
  exact.rebuild(model, {}, true);
  // Cells from x = 1 on were never seen; the first one's centre lies at 1.025.
  BW_COMPARE_NEAR(exact.query(box, 10.0).nearest->distance, 0.825, 1e-9);
}

void TestUnseenSpace::behindASurfaceIsSolid() {
  const GridGeometry geometry({-2, 2, -1.5, 1.5, 0, 5}, 0.05);
  EnvironmentModel model(geometry);
  for (int j = 0; j < geometry.rows(); ++j) {
    for (int i = 0; i < geometry.columns(); ++i) {
      model.set(i, j, 0.1F, 0);
      if (geometry.xOf(i) > 1.0) scenes::occupy(model, i, j, 1.0);  // a wall seen end-on (Fig. 21)
    }
  }
  const OrientedBox box{{0, 0, 3}, {0.4, 0.4, 0.4}};
  ExactClearance exact;
  exact.rebuild(model);
  const double gable = geometry.zOf(geometry.levelOf(1.0));
  const double toGable = std::hypot(0.825, 2.8 - gable);
  BW_COMPARE_NEAR(exact.query(box, 10.0).nearest->distance, toGable, 1e-9);
  exact.rebuild(model, {}, true);
  BW_COMPARE_NEAR(exact.query(box, 10.0).nearest->distance, 0.825, 1e-9);
}

void TestUnseenSpace::exemptCellsAreFree() {
  const GridGeometry geometry({-2, 2, -1.5, 1.5, 0, 5}, 0.05);
  EnvironmentModel model(geometry);
  std::vector<std::size_t> near;
  for (int j = 0; j < geometry.rows(); ++j) {
    for (int i = 0; i < geometry.columns(); ++i) {
      if (std::hypot(geometry.xOf(i), geometry.yOf(j)) < 1.0) near.push_back(geometry.index(i, j));
    }
  }
  ExactClearance exact;
  exact.rebuild(model, near, true);
  const Clearance found = exact.query({{0, 0, 2.5}, {0.001, 0.001, 0.001}}, 10.0);
  BW_COMPARE_NEAR(found.nearest->distance, 1.0, 0.05);
}

BOOMWATCH_TEST(TestUnseenSpace)
#include "test_unseen_space.moc"
