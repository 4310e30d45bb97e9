#include <QtTest>

#include "support/load_errors.h"
#include "support/test_registry.h"

using namespace boomwatch;

/// 1,000 simulated poses, and as many empty grapples: what the detector is worth.
class TestLoadPoses : public QObject {
  Q_OBJECT

 private:
  static constexpr int parts = 4, poses = 250;

  static void addParts() {
    QTest::addColumn<unsigned>("firstSeed");
    for (unsigned part = 0; part < parts; ++part) QTest::addRow("part %u", part) << 10000U * part;
  }

 private slots:
  void logsAreFoundWhereTheyAre_data() { addParts(); }
  void logsAreFoundWhereTheyAre() {
    QFETCH(unsigned, firstSeed);
    load_scene::Errors errors;
    load_scene::addPoses(errors, firstSeed, poses);
    qInfo("%s", qPrintable(errors.text()));
    QCOMPARE(errors.poses, poses);
    QVERIFY(errors.found() >= poses * 85 / 100);
    QVERIFY(errors.badly <= 2);  // none is wanted
    QVERIFY(load_scene::quantile(errors.axis, 0.5) < 3.0);
    QVERIFY(load_scene::quantile(errors.centre, 0.5) < 0.05);
    QVERIFY(load_scene::quantile(errors.radius, 0.5) < 0.10);
    QVERIFY(load_scene::quantile(errors.length, 0.5) < 0.10);
  }

  void anEmptyGrappleIsNoLoad_data() { addParts(); }
  void anEmptyGrappleIsNoLoad() {
    QFETCH(unsigned, firstSeed);
    const int loads = load_scene::falseLoads(firstSeed, poses);
    qInfo("%d of %d empty grapples are taken for a load", loads, poses);
    QVERIFY(loads <= poses / 100);
  }
};

BOOMWATCH_TEST(TestLoadPoses)
#include "test_load_poses_slow.moc"
