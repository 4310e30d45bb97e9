#include <QtTest>

#include "lab/experiments/chain_score.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr double rate = 20.0;
const WarningParameters limits;  // 1 m, 1 s, deadband 0.05 m, release 0.5 s

/// `count` frames with something that is seen at `distance`, and the level the chain gave.
std::vector<ChainFrame> sequence(std::size_t count, double distance, WarningLevel level) {
  std::vector<ChainFrame> frames(count);
  for (std::size_t k = 0; k < count; ++k) {
    frames[k].stamp = static_cast<double>(k) / rate;
    frames[k].truth = distance;
    frames[k].seen = frames[k].patch = distance;
    frames[k].level = level;
  }
  return frames;
}

void setLevel(std::vector<ChainFrame>& frames, std::size_t first, std::size_t last,
              WarningLevel level) {
  for (std::size_t k = first; k <= last; ++k) frames[k].level = level;
}

}  // namespace

/// Missed and false alarms are counted as the report defines them.
class TestChainScore : public QObject {
  Q_OBJECT

 private slots:
  void aWarningWithin150MillisecondsIsInTime() {
    auto frames = sequence(60, 0.9, WarningLevel::Warning);
    setLevel(frames, 20, 22, WarningLevel::Caution);
    QVERIFY(missedAlarms(frames, limits).empty());
    setLevel(frames, 23, 23, WarningLevel::Caution);  // 150 ms after the first
    const auto missed = missedAlarms(frames, limits);
    QCOMPARE(missed.size(), std::size_t{1});
    QCOMPARE(missed[0].first, std::size_t{20});
    QCOMPARE(missed[0].last, std::size_t{23});
    QVERIFY(!missed[0].withoutDistance);
  }

  void aSliverIsMissedAndSaidToBeOne() {
    auto frames = sequence(60, 0.9, WarningLevel::Caution);
    QVERIFY(!missedAlarms(frames, limits)[0].ofSliver);
    for (ChainFrame& frame : frames) frame.patch = 1.1;
    QVERIFY(missedAlarms(frames, limits)[0].ofSliver);
    for (ChainFrame& frame : frames) frame.patch.reset();
    QVERIFY(missedAlarms(frames, limits)[0].ofSliver);
    frames[30].patch = 1.0;
    QVERIFY(!missedAlarms(frames, limits)[0].ofSliver);
  }

  void everyStretchIsOneMissedAlarm() {
    auto frames = sequence(80, 0.9, WarningLevel::Collision);
    setLevel(frames, 20, 30, WarningLevel::Clear);
    setLevel(frames, 40, 50, WarningLevel::NoDistance);
    const auto missed = missedAlarms(frames, limits);
    QCOMPARE(missed.size(), std::size_t{2});
    QVERIFY(!missed[0].withoutDistance);
    QVERIFY(missed[1].withoutDistance);
  }

  void theZoneItselfCounts() {
    QCOMPARE(missedAlarms(sequence(40, 1.0, WarningLevel::Caution), limits).size(), std::size_t{1});
    QVERIFY(missedAlarms(sequence(40, 1.001, WarningLevel::Caution), limits).empty());
  }

  void whatTheCameraDoesNotSeeIsNotMissed() {
    auto frames = sequence(40, 0.5, WarningLevel::Clear);
    for (ChainFrame& frame : frames) frame.seen = 1.7;
    QVERIFY(missedAlarms(frames, limits).empty());
    for (ChainFrame& frame : frames) frame.seen.reset();
    QVERIFY(missedAlarms(frames, limits).empty());
  }

  void theBeginningIsNotJudged() {
    QVERIFY(missedAlarms(sequence(10, 0.5, WarningLevel::NoDistance), limits).empty());
    const auto missed = missedAlarms(sequence(30, 0.5, WarningLevel::NoDistance), limits);
    QCOMPARE(missed.size(), std::size_t{1});
    QCOMPARE(missed[0].first, std::size_t{10});
  }

  void aWarningOfNothingIsFalse() {
    auto frames = sequence(80, 1.5, WarningLevel::Caution);
    QVERIFY(falseAlarms(frames, limits).empty());
    setLevel(frames, 30, 31, WarningLevel::Warning);
    auto wrong = falseAlarms(frames, limits);
    QCOMPARE(wrong.size(), std::size_t{1});
    QCOMPARE(wrong[0].first, std::size_t{30});
    QCOMPARE(wrong[0].last, std::size_t{31});
    setLevel(frames, 40, 40, WarningLevel::Collision);  // 0.45 s later: the same
    QCOMPARE(falseAlarms(frames, limits).size(), std::size_t{1});
    setLevel(frames, 50, 50, WarningLevel::Collision);  // 0.5 s later: another
    QCOMPARE(falseAlarms(frames, limits).size(), std::size_t{2});
  }

  void theDeadbandIsNotFalse() {
    QVERIFY(falseAlarms(sequence(40, 1.05, WarningLevel::Warning), limits).empty());
    QCOMPARE(falseAlarms(sequence(40, 1.06, WarningLevel::Warning), limits).size(), std::size_t{1});
  }

  void whatMovesIsThereToo() {
    auto frames = sequence(40, 3.0, WarningLevel::Warning);
    for (ChainFrame& frame : frames) frame.moving = 0.8;
    QVERIFY(falseAlarms(frames, limits).empty());
    for (ChainFrame& frame : frames) frame.moving = 1.8;
    QCOMPARE(falseAlarms(frames, limits).size(), std::size_t{1});
  }

  void aFastLoadIsWarnedOfEarlier() {
    auto frames = sequence(40, 1.8, WarningLevel::Warning);
    for (ChainFrame& frame : frames) frame.speed = 1.76;  // 1.8 m in a second, with the deadband
    QVERIFY(falseAlarms(frames, limits).empty());
    for (ChainFrame& frame : frames) frame.speed = 1.7;
    QCOMPARE(falseAlarms(frames, limits).size(), std::size_t{1});
  }

  void aLoadThatBrakesWasFast() {
    auto frames = sequence(80, 1.8, WarningLevel::Caution);
    for (std::size_t k = 20; k < 30; ++k) frames[k].speed = 1.76;
    // The speed counts for half a second, and a warning may linger for 0.65 s more.
    setLevel(frames, 20, 52, WarningLevel::Warning);
    QVERIFY(falseAlarms(frames, limits).empty());
    setLevel(frames, 53, 53, WarningLevel::Warning);
    QCOMPARE(falseAlarms(frames, limits).size(), std::size_t{1});
  }

  void aWarningMayLinger() {
    auto frames = sequence(80, 2.0, WarningLevel::Caution);
    for (std::size_t k = 20; k < 30; ++k) frames[k].truth = 0.8;
    setLevel(frames, 20, 42, WarningLevel::Warning);  // 13 frames, 0.65 s, after it was near
    QVERIFY(falseAlarms(frames, limits).empty());
    setLevel(frames, 43, 43, WarningLevel::Warning);
    const auto wrong = falseAlarms(frames, limits);
    QCOMPARE(wrong.size(), std::size_t{1});
    QCOMPARE(wrong[0].first, std::size_t{43});
  }
};

BOOMWATCH_TEST(TestChainScore)
#include "test_chain_score.moc"
