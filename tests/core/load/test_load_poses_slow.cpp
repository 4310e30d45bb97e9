#include <QtTest>

#include "support/load_errors.h"
#include "support/test_registry.h"

using namespace boomwatch;

/// 1,000 simulated poses, and as many empty grapples: what the detector is worth.
class TestLoadPoses : public QObject {
  Q_OBJECT

 private:
  static constexpr int parts = 4, poses = 250;
  load_scene::Errors m_errors;
  int m_falseLoads = 0;

  static void addParts() {
    QTest::addColumn<int>("part");
    for (int part = 0; part < parts; ++part) QTest::addRow("part %d", part) << part;
  }

 private slots:
  void logsAreFoundWhereTheyAre_data() { addParts(); }
  void logsAreFoundWhereTheyAre() {
    QFETCH(int, part);
    load_scene::addPoses(m_errors, 10000U * static_cast<unsigned>(part), poses);
    if (part + 1 < parts) return;
    qInfo("%s", qPrintable(m_errors.text()));
    QCOMPARE(m_errors.poses, parts * poses);
    QVERIFY(m_errors.found() >= 850);
    QVERIFY(m_errors.badly <= 5);  // none is wanted
    QVERIFY(load_scene::quantile(m_errors.axis, 0.5) < 3.0);
    QVERIFY(load_scene::quantile(m_errors.centre, 0.5) < 0.05);
    QVERIFY(load_scene::quantile(m_errors.radius, 0.5) < 0.10);
    QVERIFY(load_scene::quantile(m_errors.length, 0.5) < 0.10);
  }

  void anEmptyGrappleIsNoLoad_data() { addParts(); }
  void anEmptyGrappleIsNoLoad() {
    QFETCH(int, part);
    m_falseLoads += load_scene::falseLoads(10000U * static_cast<unsigned>(part), poses);
    if (part + 1 < parts) return;
    qInfo("%d of %d empty grapples are taken for a load", m_falseLoads, parts * poses);
    QVERIFY(m_falseLoads <= parts * poses / 100);
  }
};

BOOMWATCH_TEST(TestLoadPoses)
#include "test_load_poses_slow.moc"
