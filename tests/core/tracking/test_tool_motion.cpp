#include <QtTest>
#include <cmath>
#include <random>

#include "support/compare_near.h"
#include "support/test_registry.h"
#include "tracking/tool_motion.h"

using namespace boomwatch;
using Eigen::Vector3f;

namespace {

const TrackingParameters defaults;

/// Where a tool is that moves evenly.
Vector3f evenly(double t) { return Vector3f(-1.0F, 0.5F, 4.0F) + Vector3f(0.8F, -0.2F, 0.4F) * t; }

/// Fed with `seconds` of even motion, `rate` frames a second.
ToolMotion moved(double seconds, double rate) {
  ToolMotion motion;
  for (int i = 0; i <= static_cast<int>(seconds * rate); ++i) {
    motion.update(i / rate, evenly(i / rate), defaults);
  }
  return motion;
}

}  // namespace

class TestToolMotion : public QObject {
  Q_OBJECT
 private slots:
  void knowsNothingAtFirst();
  void followsEvenMotionWithoutLag_data();
  void followsEvenMotionWithoutLag();
  void smoothsNoise();
  void goesOnAsItMovedWhileNothingIsMeasured();
  void isForgottenBeyondTheAge();
  void oneOutlierIsNotBelieved();
  void outliersThatAgreeAre();
  void outliersOutOfReachContradict();
  void outliersApartFromTheLoadContradict();
  void whatIsExpectedAnywhereIsNotInReach();
  void whatCameOutOfReachAndWentIsForgotten();
  void framesWithoutTimeBetweenThemContradictNothing();
  void littleCertaintyContradictsNothing();
  void outliersThatDoNotAgreeAreNot();
  void aClockThatGoesBackwardsBeginsAnew();
  void theSameStampTwiceIsNoFault();
  void velocityIsAbsentUntilItIsKnown();
};

void TestToolMotion::knowsNothingAtFirst() {
  ToolMotion motion;
  QVERIFY(!motion.point() && !motion.velocity() && !motion.age());
  motion.update(3.0, std::nullopt, defaults);
  QVERIFY(!motion.point() && !motion.velocity() && !motion.age());
}

void TestToolMotion::followsEvenMotionWithoutLag_data() {
  QTest::addColumn<double>("rate");
  QTest::newRow("4 frames a second") << 4.0;
  QTest::newRow("30 frames a second") << 30.0;
}

void TestToolMotion::followsEvenMotionWithoutLag() {
  QFETCH(double, rate);
  const ToolMotion motion = moved(3.0, rate);
  QVERIFY((*motion.point() - evenly(3.0)).norm() < 0.01F);
  QVERIFY((*motion.velocity() - Vector3f(0.8F, -0.2F, 0.4F)).norm() < 0.03F);
  QCOMPARE(*motion.age(), 0.0);
}

void TestToolMotion::smoothsNoise() {
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0F, 0.05F);
  ToolMotion motion;
  double raw = 0.0, smooth = 0.0;
  for (int i = 0; i < 300; ++i) {
    const Vector3f truth = evenly(i / 25.0);
    const Vector3f measured = truth + Vector3f(noise(random), noise(random), noise(random));
    motion.update(i / 25.0, measured, defaults);
    if (i < 50) continue;
    raw += (measured - truth).squaredNorm();
    smooth += (*motion.point() - truth).squaredNorm();
  }
  QVERIFY2(smooth < 0.5 * raw, qPrintable(QString::number(smooth / raw)));
}

void TestToolMotion::goesOnAsItMovedWhileNothingIsMeasured() {
  ToolMotion motion = moved(3.0, 20.0);
  for (int i = 1; i <= 9; ++i) {
    motion.update(3.0 + i / 20.0, std::nullopt, defaults);
    QVERIFY((*motion.point() - evenly(3.0 + i / 20.0)).norm() < 0.05F);
    BW_COMPARE_NEAR(*motion.age(), i / 20.0, 1e-9);
  }
}

void TestToolMotion::isForgottenBeyondTheAge() {
  ToolMotion motion = moved(3.0, 20.0);
  motion.update(3.51, std::nullopt, defaults);
  QVERIFY(!motion.point() && !motion.velocity());
  BW_COMPARE_NEAR(*motion.age(), 0.51, 1e-9);
  // Wherever it comes back, it is taken for what it is.
  motion.update(3.6, Vector3f(3, 1, 5), defaults);
  QCOMPARE(*motion.point(), Vector3f(3, 1, 5));
  QVERIFY(!motion.velocity());
  QCOMPARE(*motion.age(), 0.0);
}

void TestToolMotion::oneOutlierIsNotBelieved() {
  ToolMotion motion = moved(3.0, 20.0);
  motion.update(3.05, Vector3f(evenly(3.05) + Vector3f(0, 0, 4)), defaults);
  QVERIFY((*motion.point() - evenly(3.05)).norm() < 0.05F);
  QVERIFY(*motion.age() > 0.0);
  motion.update(3.1, evenly(3.1), defaults);
  QVERIFY((*motion.point() - evenly(3.1)).norm() < 0.05F);
  QCOMPARE(*motion.age(), 0.0);
}

void TestToolMotion::outliersThatAgreeAre() {
  ToolMotion motion = moved(3.0, 20.0);
  const Vector3f elsewhere = evenly(3.0) + Vector3f(0, 0, 0.8F);
  motion.update(3.05, elsewhere, defaults);
  motion.update(3.1, elsewhere, defaults);
  QVERIFY((*motion.point() - elsewhere).norm() > 0.5F);
  motion.update(3.15, elsewhere, defaults);
  QVERIFY((*motion.point() - elsewhere).norm() < 0.01F);
  QCOMPARE(*motion.age(), 0.0);
  QVERIFY(!motion.contradicted());
}

void TestToolMotion::outliersApartFromTheLoadContradict() {
  ToolMotion motion = moved(3.0, 20.0);
  const auto besideIt = [](double t) { return Vector3f(evenly(t) + Vector3f(0, -0.8F, 0)); };
  for (int i = 1; i <= 60; ++i) {
    const double t = 3.0 + i * 0.05;
    motion.update(t, besideIt(3.0), defaults, evenly(t));
    QVERIFY(!motion.believed());
    // Not before it is lost: a wrong depth for a moment is no fault of the tracker.
    QCOMPARE(motion.contradicted(), !motion.point());
  }
  // Nor is what comes back so far from the load, though the tool could be there by now.
  ToolMotion back = moved(3.0, 20.0);
  for (int i = 1; i <= 8; ++i) back.update(3.0 + i * 0.05, std::nullopt, defaults);
  ToolMotion without = back;
  back.update(3.45, besideIt(3.45), defaults, evenly(3.45));
  without.update(3.45, besideIt(3.45), defaults);
  QVERIFY(!back.believed() && without.believed());
  // The load is no longer seen there: it may have been another one.
  motion.update(6.05, besideIt(3.0), defaults);
  QVERIFY(motion.believed());
  // What moves on evenly needs no load to be believed: that may have been laid down.
  ToolMotion leaving = moved(3.0, 20.0);
  for (int i = 1; i <= 60; ++i) {
    leaving.update(3.0 + i * 0.05, evenly(3.0 + i * 0.05), defaults, evenly(3.0));
    QVERIFY(leaving.believed());
  }
}

void TestToolMotion::outliersOutOfReachContradict() {
  ToolMotion motion = moved(3.0, 20.0);
  const Vector3f elsewhere = evenly(3.0) + Vector3f(0, 0, 4);
  int contradictions = 0;
  std::optional<double> accepted;
  for (int i = 1; i <= 80 && !accepted; ++i) {
    const double stamp = 3.0 + i * 0.05;
    motion.update(stamp, elsewhere, defaults);
    // Carried on with its velocity as long as any tool that is not seen.
    QCOMPARE(motion.point().has_value(), stamp < 3.525 || motion.believed());
    QVERIFY(!motion.point() || motion.believed() || motion.point()->z() < 6.0F);
    contradictions += motion.contradicted();
    if (motion.believed()) accepted = stamp;
  }
  QCOMPARE(contradictions, 50);
  QVERIFY(accepted);
  BW_COMPARE_NEAR(*accepted, 6.05, 0.06);
}

/// A maximal age of ten seconds does not make a leap of one frame credible.
void TestToolMotion::whatIsExpectedAnywhereIsNotInReach() {
  TrackingParameters patient;
  patient.maxToolAge = 10.0;
  ToolMotion motion = moved(3.0, 20.0);
  motion.update(5.4, Vector3f(evenly(3.0) + Vector3f(0, 0, 17)), patient);
  QVERIFY(!motion.believed());
  motion.update(5.45, evenly(5.45), patient);
  QVERIFY(motion.believed());
}

void TestToolMotion::whatCameOutOfReachAndWentIsForgotten() {
  ToolMotion motion = moved(3.0, 20.0);
  for (int i = 1; i <= 15; ++i) {
    motion.update(3.0 + i * 0.05, Vector3f(evenly(3.0) + Vector3f(0, 0, 4)), defaults);
  }
  QVERIFY(motion.contradicted());
  motion.update(3.8, evenly(3.8), defaults);
  QVERIFY(!motion.contradicted());
  QVERIFY(motion.believed());
  QVERIFY((*motion.point() - evenly(3.8)).norm() < 0.05F);
}

/// Recordings with stamps in whole seconds.
void TestToolMotion::framesWithoutTimeBetweenThemContradictNothing() {
  ToolMotion motion = moved(1.0, 20.0);
  for (int i = 0; i < 100; ++i) {
    motion.update(2.0 + i / 25, evenly(2.0 + i / 25.0), defaults);
    QVERIFY(!motion.contradicted());
  }
  QVERIFY((*motion.point() - evenly(6.0)).norm() < 0.5F);
}

/// Before many measurements agreed it may be the first that were wrong.
void TestToolMotion::littleCertaintyContradictsNothing() {
  ToolMotion motion = moved(0.2, 20.0);
  const Vector3f elsewhere = evenly(0.2) + Vector3f(0, 0, 4);
  for (int i = 1; i <= 3; ++i) motion.update(0.2 + i * 0.05, elsewhere, defaults);
  QVERIFY((*motion.point() - elsewhere).norm() < 0.01F);
}

void TestToolMotion::outliersThatDoNotAgreeAreNot() {
  ToolMotion motion = moved(3.0, 20.0);
  for (int i = 1; i <= 8; ++i) {
    const Vector3f wild(static_cast<float>(i % 2 ? 40 : -40), 0, 10);
    motion.update(3.0 + i * 0.05, wild, defaults);
    QVERIFY((*motion.point() - evenly(3.0 + i * 0.05)).norm() < 0.1F);
  }
}

void TestToolMotion::aClockThatGoesBackwardsBeginsAnew() {
  ToolMotion motion = moved(3.0, 20.0);
  motion.update(0.1, std::nullopt, defaults);
  QVERIFY(!motion.point() && !motion.age());
  motion.update(0.2, evenly(0.2), defaults);
  QCOMPARE(*motion.point(), evenly(0.2));
}

void TestToolMotion::theSameStampTwiceIsNoFault() {
  ToolMotion motion = moved(3.0, 20.0);
  motion.update(3.0, evenly(3.0), defaults);
  QVERIFY((*motion.point() - evenly(3.0)).norm() < 0.02F);
  QVERIFY(motion.velocity()->allFinite());
}

void TestToolMotion::velocityIsAbsentUntilItIsKnown() {
  ToolMotion motion;
  motion.update(0.0, evenly(0.0), defaults);
  motion.update(0.05, evenly(0.05), defaults);
  QVERIFY(!motion.velocity());
  motion.update(0.1, evenly(0.1), defaults);
  QVERIFY(motion.velocity());
}

BOOMWATCH_TEST(TestToolMotion)
#include "test_tool_motion.moc"
