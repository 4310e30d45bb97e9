#include <QtTest>

#include "pipeline/warning_memory.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

using Level = WarningLevel;

Clearance at(double distance) {
  Clearance clearance;
  clearance.state = ClearanceState::Measured;
  clearance.reason = Reason::None;
  clearance.nearest =
      Nearest{distance, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), LoadPart::Face, 0.0};
  return clearance;
}

Clearance nothing() {
  Clearance clearance;
  clearance.state = ClearanceState::NothingInRange;
  clearance.reason = Reason::None;
  return clearance;
}

Approach contactIn(std::optional<double> seconds, double closing = 0.5) {
  return {Eigen::Vector3d::UnitZ(), closing, seconds};
}

/// Feeds a machine with frames, sixteen a second.
class Run {
 public:
  explicit Run(WarningParameters parameters = {}) : m_parameters(parameters) {}
  Level feed(const Clearance& clearance, std::optional<Approach> approach = {}) {
    m_memory = nextWarning(m_memory, {m_stamp, clearance, approach}, m_parameters);
    m_stamp += 1.0 / 16;
    return m_memory.level;
  }
  void setClock(double stamp) { m_stamp = stamp; }
  /// Frames until the level changes, at most 100.
  int framesUntilChange(const Clearance& clearance, std::optional<Approach> approach = {}) {
    const Level before = m_memory.level;
    for (int n = 1; n <= 100; ++n) {
      if (feed(clearance, approach) != before) return n;
    }
    return 101;
  }

 private:
  WarningParameters m_parameters;
  WarningMemory m_memory;
  double m_stamp = 0.0;
};

}  // namespace

class TestWarningMachine : public QObject {
  Q_OBJECT

 private slots:
  void goesUpAtOnce() {
    Run run;
    QVERIFY(run.feed(at(3.0)) == Level::Clear);
    QVERIFY(run.feed(at(2.0)) == Level::Caution);
    QVERIFY(run.feed(at(1.0)) == Level::Warning);
    QVERIFY(run.feed(at(0.0)) == Level::Collision);
  }

  void comesDownLateAndStepByStep() {
    Run run;
    QVERIFY(run.feed(at(0.5)) == Level::Warning);
    // 0.5 s: the frame at which it began, and eight more.
    QCOMPARE(run.framesUntilChange(at(1.5)), 9);
    QVERIFY(run.feed(at(1.5)) == Level::Caution);
    QCOMPARE(run.framesUntilChange(nothing()), 9);
    QVERIFY(run.feed(nothing()) == Level::Clear);
  }

  void aNoisyDistanceAtTheThresholdDoesNotFlicker() {
    Run run;
    run.feed(at(0.99));
    for (int n = 0; n < 200; ++n) {
      QVERIFY(run.feed(at(n % 2 ? 0.98 : 1.03)) == Level::Warning);
    }
    // Nor one that leaves the deadband for less than the delay.
    for (int n = 0; n < 200; ++n) {
      QVERIFY(run.feed(at(n % 9 ? 1.2 : 1.0)) == Level::Warning);
    }
  }

  void theDeadbandEndsWhereItSays() {
    Run inside, outside;
    inside.feed(at(0.9));
    outside.feed(at(0.9));
    QCOMPARE(inside.framesUntilChange(at(1.049)), 101);
    QCOMPARE(outside.framesUntilChange(at(1.051)), 9);
  }

  void timeToContactRaisesTheLevel() {
    Run run;
    QVERIFY(run.feed(at(4.0), contactIn(2.5)) == Level::Clear);
    QVERIFY(run.feed(at(4.0), contactIn(1.9)) == Level::Caution);
    QVERIFY(run.feed(at(4.0), contactIn(0.9)) == Level::Warning);
    // Time alone never says that they touch.
    QVERIFY(run.feed(at(4.0), contactIn(0.0)) == Level::Warning);
    WarningParameters off;
    off.cautionTime = off.warningTime = 0.0;
    QVERIFY(Run(off).feed(at(4.0), contactIn(0.1)) == Level::Clear);
  }

  void retreatIsNotPunished() {
    Run run;
    QVERIFY(run.feed(at(0.9), contactIn(0.5)) == Level::Warning);
    // Still inside the zone: the distance counts, whichever way it moves.
    QVERIFY(run.feed(at(0.95), contactIn({}, -1.0)) == Level::Warning);
    // Past it: no delay.
    QVERIFY(run.feed(at(1.1), contactIn({}, -1.0)) == Level::Caution);
  }

  void unknownIsNeverTheLastLevel() {
    Run run;
    run.feed(at(0.5));
    QVERIFY(run.feed(Clearance::unknown(Reason::FewDepthPixels)) == Level::NoDistance);
    // And what was before holds nothing up.
    QVERIFY(run.feed(at(1.5)) == Level::Caution);
  }

  void aClockSetBackDoesNotHoldTheLevelForEver() {
    Run run;
    run.setClock(1000.0);
    run.feed(at(0.5));
    run.feed(at(1.5));
    run.setClock(0.0);
    QVERIFY(run.framesUntilChange(at(1.5)) <= 10);
  }
};

BOOMWATCH_TEST(TestWarningMachine)
#include "test_warning_memory.moc"
