#include <QtTest>

#include "../load_errors.h"

using namespace boomwatch;

/// 1,000 simulated poses, and as many empty grapples: what the detector is worth.
class TestLoadPoses : public QObject {
  Q_OBJECT
 private slots:
  void logsAreFoundWhereTheyAre() {
    const auto errors = load_scene::errorsOf(0, 1000);
    qInfo("%s", qPrintable(errors.text()));
    QVERIFY(errors.found() >= 750);
    QVERIFY(load_scene::quantile(errors.axis, 0.5) < 3.0);
    QVERIFY(load_scene::quantile(errors.centre, 0.5) < 0.05);
    QVERIFY(load_scene::quantile(errors.radius, 0.5) < 0.10);
    QVERIFY(load_scene::quantile(errors.length, 0.5) < 0.10);
  }

  void anEmptyGrappleIsNoLoad() {
    const int wrong = load_scene::falseLoads(0, 1000);
    qInfo("%d of 1000 empty grapples are taken for a load", wrong);
    QVERIFY(wrong <= 10);
  }
};

QTEST_GUILESS_MAIN(TestLoadPoses)
#include "test_load_poses_slow.moc"
