#include <QtTest>

#include "collision/approach.h"
#include "support/collision_scenes.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

const Bounds bounds{-4.0, 4.0, -4.0, 4.0, 0.0, 10.0};

ExactClearance floorAt(double z) {
  ExactClearance exact;
  exact.rebuild(scenes::flatFloor(GridGeometry(bounds, 0.04), z));
  return exact;
}

OrientedBox upright(const Vector3d& centre) {
  OrientedBox box;
  box.centre = centre;
  box.size.setConstant(0.4);
  return box;
}

}  // namespace

class TestApproach : public QObject {
  Q_OBJECT

 private slots:
  void theSlopeOfAStraightPathIsItsVelocity() {
    LoadMotion motion;
    const Vector3d velocity(0.3, -0.2, 1.1);
    for (int n = 0; n < 40; ++n) {
      const auto found = motion.update(0.05 * n, Vector3d(1, 2, 3) + 0.05 * n * velocity);
      // Three frames are too short, four are enough.
      QCOMPARE(found.has_value(), n >= 3);
      if (found) QVERIFY((*found - velocity).norm() < 1e-9);
    }
  }

  void noiseIsAveragedOut() {
    LoadMotion motion;
    scenes::Random random(5);
    double worst = 0.0;
    int told = 0;
    for (int n = 0; n < 400; ++n) {
      const Vector3d noise(0, 0, scenes::uniform(random, -0.01, 0.01));
      const Vector3d found = motion.update(0.05 * n, noise).value_or(Vector3d::Zero());
      // Two neighbouring frames alone would show up to 0.4 m/s.
      if (n > 10) worst = std::max(worst, found.norm());
      told += found.norm() > 0.0;
    }
    QVERIFY2(worst < 0.06, qPrintable(QString::number(worst)));
    QVERIFY(told > 390);
  }

  void nothingIsSaidAfterAGapOrAClockSetBack() {
    LoadMotion motion;
    for (int n = 0; n < 10; ++n) motion.update(0.05 * n, Vector3d::Zero());
    QVERIFY(motion.update(0.5, Vector3d::Zero()));
    QVERIFY(!motion.update(1.5, Vector3d::UnitX()));
    QVERIFY(!motion.update(0.2, Vector3d::UnitX()));
    QVERIFY(!motion.update(0.2, Vector3d::UnitX()));
  }

  void contactIsWhereAndWhenTheyMeet() {
    const ExactClearance exact = floorAt(6.0);
    const OrientedBox load = upright({0, 0, 4.0});
    const double gap = exact.query(load, 10).nearest->distance;
    const double slack = exact.query(load, 10).nearest->quantisation;
    for (const double speed : {0.2, 1.0, 3.0}) {
      const auto time = timeToContact(exact, load, {0, 0, speed}, 60.0);
      QVERIFY(time);
      QVERIFY(*time <= gap / speed);
      QVERIFY(*time >= (gap - slack) / speed - 1e-9);
    }
    // At an angle it meets the same floor later.
    const auto slanted = timeToContact(exact, load, {1.0, 0, 1.0}, 60.0);
    QVERIFY(slanted && *slanted <= gap && *slanted >= gap - slack - 1e-9);
  }

  void awayAndAlongDoNotMeet() {
    const ExactClearance exact = floorAt(6.0);
    const OrientedBox load = upright({0, 0, 5.0});
    QVERIFY(!timeToContact(exact, load, {0, 0, -1.0}, 3.0));
    QVERIFY(!timeToContact(exact, load, {1.0, 0, 0}, 2.0));
    QVERIFY(!timeToContact(exact, load, Vector3d::Zero(), 10.0));
    QVERIFY(!timeToContact(exact, load, {0, 0, 0.1}, 2.0));
  }

  void aThinThingOnThePathIsNotJumpedOver() {
    EnvironmentModel model(GridGeometry(bounds, 0.04));
    const GridGeometry& g = model.geometry();
    for (int row = 0; row < g.rows(); ++row) scenes::occupy(model, g.columnOf(1.5), row, 4.0);
    ExactClearance exact;
    exact.rebuild(model);
    // Fast enough to be past it within a tenth of a second.
    const auto time = timeToContact(exact, upright({0, 0, 4.0}), {30.0, 0, 0}, 1.0);
    QVERIFY(time);
    BW_COMPARE_NEAR(*time, 1.3 / 30.0, 0.06 / 30.0);
  }

  void touchingAlreadyIsNow() {
    const ExactClearance exact = floorAt(6.0);
    QCOMPARE(timeToContact(exact, upright({0, 0, 6.0}), {0, 0, 1.0}, 5.0), std::optional(0.0));
  }

  void withoutAModelThereIsNoContact() {
    const ExactClearance none;
    QVERIFY(!timeToContact(none, upright({0, 0, 4.0}), {0, 0, 1.0}, 5.0));
  }
};

BOOMWATCH_TEST(TestApproach)
#include "test_approach.moc"
