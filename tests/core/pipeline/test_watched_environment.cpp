#include <QtTest>

#include "pipeline/watched_environment.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

/// A box of 0.4 m at (0, 0, z).
OrientedBox boxAt(double z) {
  OrientedBox box;
  box.centre = {0.0, 0.0, z};
  box.size = {0.4, 0.4, 0.4};
  return box;
}

bool seeWall(WatchedEnvironment& environment, float z, const Parameters& parameters) {
  const auto cloud = wallCloud(z);
  return environment.update(*cloud, separateStatic(*cloud, {}, {}, parameters), parameters);
}

}  // namespace

class TestWatchedEnvironment : public QObject {
  Q_OBJECT
 private slots:
  void theDistanceIsThatToTheWallBehindTheBox() {
    const Parameters parameters = smallParameters();
    WatchedEnvironment environment;
    for (int k = 0; k < 10; ++k) seeWall(environment, 4.0F, parameters);
    const Clearance clearance = environment.clearanceOf(boxAt(2.5), parameters);
    QVERIFY(clearance.state == ClearanceState::Measured);
    QVERIFY(clearance.nearest);
    // 5 m have 255 levels of depth.
    const double wrong = clearance.nearest->distance - (4.0 - 2.7);
    QVERIFY2(std::abs(wrong) < 5.0 / 255.0, qPrintable(QString::number(wrong)));
    QVERIFY(clearance.evidence);
    QVERIFY(environment.suppressed().empty());
  }

  void nothingIsKnownBeforeAnythingCanHaveEntered() {
    const Parameters parameters = smallParameters();
    const int needed = *framesToEnter(parameters.model);
    WatchedEnvironment environment;
    for (int k = 0; k < needed; ++k) {
      const Clearance clearance = environment.clearanceOf(boxAt(2.5), parameters);
      QVERIFY(clearance.state == ClearanceState::Unknown);
      QVERIFY(clearance.reason == Reason::NoModel);
      seeWall(environment, 4.0F, parameters);
    }
    QVERIFY(environment.clearanceOf(boxAt(2.5), parameters).reason != Reason::NoModel);
  }

  void aModelBeginsAnewWhenItIsForgottenOrChangesItsSize() {
    Parameters parameters = smallParameters();
    WatchedEnvironment environment;
    QVERIFY(seeWall(environment, 4.0F, parameters));
    QVERIFY(!seeWall(environment, 4.0F, parameters));
    environment.forget();
    QVERIFY(seeWall(environment, 4.0F, parameters));
    QCOMPARE(environment.model().frames(), std::size_t{1});
    parameters.model.resolution = 0.1;
    QVERIFY(seeWall(environment, 4.0F, parameters));
    QVERIFY(!seeWall(environment, 4.0F, parameters));
  }

  void aBoxBesideAllThatWasSeenHasNoDistance() {
    Parameters parameters = smallParameters();
    parameters.bounds = {-20.0, 20.0, -2.0, 2.0, 0.0, 5.0};
    WatchedEnvironment environment;
    for (int k = 0; k < 10; ++k) seeWall(environment, 4.0F, parameters);
    OrientedBox box = boxAt(2.5);
    box.centre.x() = 15.0;
    QVERIFY(environment.clearanceOf(box, parameters).reason == Reason::NothingObserved);
  }
};

BOOMWATCH_TEST(TestWatchedEnvironment)
#include "test_watched_environment.moc"
