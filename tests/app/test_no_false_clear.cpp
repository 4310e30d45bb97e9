#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <limits>

#include "support/program_run.h"
#include "support/test_registry.h"

/// What was not measured is never shown as clear, end to end.
class TestNoFalseClear : public QObject {
  Q_OBJECT

 private slots:
  void aLoadThatTouchesTheFarBoundIsNotCalledClear();
  void whatGivesNoDepthAnyMoreIsNotCalledClear();
  void surfacesThatAreTakenForNoiseAreNotCalledFree();
  void whatRaysAreTooShortForIsNotCalledClear();

 private:
  QString path(const QString& name) const { return m_folder.filePath(name); }

  QTemporaryDir m_folder;
};

/// The ground 0.25 m below the load is beyond z_max: nobody watches there.
void TestNoFalseClear::aLoadThatTouchesTheFarBoundIsNotCalledClear() {
  for (int i = 0; i < 6; ++i) {
    writeCloud(path(QString("far/%1.pcd").arg(i)), [i](int, int) { return unsteady(10.1F, i); });
  }
  const ProgramRun result =
      runProgram({"--source", "cloud:" + path("far"), "--load", "0,0,9.7,0.3,0.3,0.3,0,0,0"});
  QCOMPARE(result.lines.constLast()["level"].toString(), QStringLiteral("no_distance"));
  QCOMPARE(result.lines.constLast()["reason"].toString(), QStringLiteral("nothing_observed"));
}

/// A wall in front of which the load hangs stops giving depth (sun, shadow, dirt on the lens).
void TestNoFalseClear::whatGivesNoDepthAnyMoreIsNotCalledClear() {
  for (int i = 0; i < 40; ++i) {
    writeCloud(path(QString("blind/%1.pcd").arg(i, 2, 10, QLatin1Char('0'))), [i](int x, int) {
      const bool blind = i >= 8 && x < cloudSide - 8;
      return blind ? std::numeric_limits<float>::quiet_NaN() : unsteady(3.0F, i);
    });
  }
  const ProgramRun result = runWithLoad("cloud:" + path("blind"));
  QCOMPARE(result.lines[7]["level"].toString(), QStringLiteral("warning"));
  QCOMPARE(result.lines.constLast()["state"].toString(), QStringLiteral("unknown"));
}

void TestNoFalseClear::surfacesThatAreTakenForNoiseAreNotCalledFree() {
  for (int i = 0; i < 8; ++i) {
    writeCloud(path(QString("noise/%1.pcd").arg(i)), [i](int, int) { return unsteady(3.0F, i); });
  }
  const ProgramRun noise =
      runWithLoad("cloud:" + path("noise"), {"--set", "cluster_minimum=100000"});
  QCOMPARE(noise.lines.constLast()["reason"].toString(), QStringLiteral("nothing_observed"));
  const ProgramRun coarse = runWithLoad("cloud:" + path("noise"), {"--set", "resolution=0.12"});
  QVERIFY(coarse.lines.constLast()["distance_m"].toDouble() < 0.9);
  QCOMPARE(coarse.lines.constLast()["level"].toString(), QStringLiteral("warning"));
}

/// The ground is 4.9 m behind the load, and a pillar stands 1.7 m beside it: rays of 0.8 m see the
/// first alone.
void TestNoFalseClear::whatRaysAreTooShortForIsNotCalledClear() {
  for (int i = 0; i < 8; ++i) {
    writeCloud(path(QString("pillar/%1.pcd").arg(i)),
               [i](int x, int) { return unsteady(x >= cloudSide - 5 ? 2.0F : 7.0F, i); });
  }
  const QString pillar = "cloud:" + path("pillar");
  const QJsonObject truth = runWithLoad(pillar).lines.constLast();
  QVERIFY(truth["distance_m"].toDouble() > 1.6 && truth["distance_m"].toDouble() < 1.75);
  const QStringList rays{"--set", "clearance_method=rays", "--set"};
  const ProgramRun brief = runWithLoad(pillar, rays + QStringList{"radius=20"});
  QCOMPARE(brief.lines.constLast()["reason"].toString(), QStringLiteral("search_too_short"));
  QCOMPARE(brief.lines.constLast()["level"].toString(), QStringLiteral("no_distance"));
  QVERIFY(brief.lines.constLast()["distance_m"].isNull());
  QVERIFY(brief.errors.contains("the search ends at 0.8 m"));
  const ProgramRun longer = runWithLoad(pillar, rays + QStringList{"radius=50"});
  QCOMPARE(longer.lines.constLast()["level"].toString(), QStringLiteral("caution"));
}

BOOMWATCH_TEST(TestNoFalseClear)
#include "test_no_false_clear.moc"
