#include "sources/player.h"

#include <QtTest>

#include "support/fake_source.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace std::chrono_literals;
using Status = ReadResult::Status;

class TestPlayer : public QObject {
  Q_OBJECT

 private:
  static constexpr Player::TimePoint start{1000s};

  static Player make(const test::Script& script = {}) {
    return Player(std::make_unique<test::FakeSource>(script));
  }
  /// Index of the frame that is due at `now`; -1: none.
  static int frameAt(Player& player, Player::TimePoint now) {
    const auto read = player.poll(now, 0ms);
    return read && read->frame ? static_cast<int>(read->frame->sequence) : -1;
  }

 private slots:
  void beginsPausedAndGivesNothing() {
    Player player = make();
    QVERIFY(!player.poll(start, 0ms));
    QVERIFY(!player.due());
    QCOMPARE(player.status().state, PlayState::Paused);
    QVERIFY(!player.status().position);
  }

  void firstFrameIsDueAtOnceAndTheNextByItsStamp() {
    Player player = make();
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 99ms), -1);
    QCOMPARE(*player.due(), start + 100ms);
    QCOMPARE(frameAt(player, start + 100ms), 1);
  }

  void irregularStampsAreKept() {
    test::Script script;
    script.stamp = [](std::size_t i) { return std::array{0.0, 0.5, 0.6}[i % 3]; };
    Player player = make(script);
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 499ms), -1);
    QCOMPARE(frameAt(player, start + 500ms), 1);
    QCOMPARE(frameAt(player, start + 599ms), -1);
    QCOMPARE(frameAt(player, start + 601ms), 2);
  }

  void stampsThatStandStillFallBackToTheNominalRate() {
    test::Script script;
    script.info.nominalRate = 4.0;
    script.stamp = [](std::size_t) { return 7.0; };
    Player player = make(script);
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 249ms), -1);
    QCOMPARE(frameAt(player, start + 250ms), 1);
  }

  void longGapsAreNotSatOut() {
    test::Script script;
    script.stamp = [](std::size_t i) { return 3600.0 * static_cast<double>(i); };
    Player player = make(script);
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 1999ms), -1);
    QCOMPARE(frameAt(player, start + 2s), 1);
  }

  void speedScalesTime_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("wait");
    QTest::newRow("half") << 0.5 << 200;
    QTest::newRow("double") << 2.0 << 50;
    QTest::newRow("slower than allowed") << 0.001 << 1000;
    QTest::newRow("faster than allowed") << 1000.0 << 10;
  }
  void speedScalesTime() {
    QFETCH(double, speed);
    QFETCH(int, wait);
    Player player = make();
    player.setSpeed(speed);
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + std::chrono::milliseconds(wait - 1)), -1);
    QCOMPARE(frameAt(player, start + std::chrono::milliseconds(wait + 1)), 1);
  }

  void unlimitedSpeedIsAlwaysDue() {
    Player player = make();
    player.setSpeed(Player::unlimited);
    player.play();
    for (int i = 0; i < 10; ++i) QCOMPARE(frameAt(player, start), i);
  }

  void beingLateDoesNotEndInABurst() {
    Player player = make();
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 10s), 1);
    QCOMPARE(frameAt(player, start + 10s + 50ms), -1);
    QCOMPARE(frameAt(player, start + 10s + 100ms), 2);
  }

  void smallDelaysDoNotAddUp() {
    Player player = make();
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 130ms), 1);
    QCOMPARE(frameAt(player, start + 199ms), -1);
    QCOMPARE(frameAt(player, start + 201ms), 2);
  }

  void pauseHoldsAndPlayGoesOnWithTheNextFrame() {
    Player player = make();
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 1ms), -1);
    player.pause();
    QVERIFY(!player.due());
    QCOMPARE(frameAt(player, start + 10s), -1);
    player.play();
    QCOMPARE(frameAt(player, start + 10s), 1);
  }

  void stepsOneFrameEitherWayAndStaysPaused() {
    Player player = make();
    player.step(1);
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 10s), -1);
    player.step(1);
    QCOMPARE(frameAt(player, start), 1);
    player.step(1);
    QCOMPARE(frameAt(player, start), 2);
    player.step(-1);
    QCOMPARE(frameAt(player, start), 1);
    QCOMPARE(player.status().state, PlayState::Paused);
    QCOMPARE(player.status().position, std::optional<std::size_t>(1));
  }

  void stepBackFromTheFirstFrameDoesNothing() {
    Player player = make();
    player.step(1);
    QCOMPARE(frameAt(player, start), 0);
    player.step(-1);
    QCOMPARE(frameAt(player, start), -1);
  }

  void seekShowsTheFrameEvenWhilePaused() {
    Player player = make();
    QVERIFY(player.seek(7));
    QCOMPARE(frameAt(player, start), 7);
    QCOMPARE(frameAt(player, start), -1);
    QVERIFY(!player.seek(10));
    QCOMPARE(frameAt(player, start), -1);
  }

  void seekWhilePlayingGoesOnFromThere() {
    Player player = make();
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QCOMPARE(frameAt(player, start + 1ms), -1);
    QVERIFY(player.seek(5));
    QCOMPARE(frameAt(player, start + 2ms), 5);
    QCOMPARE(frameAt(player, start + 101ms), -1);
    QCOMPARE(frameAt(player, start + 102ms), 6);
  }

  void endIsSaidOnceAndPlayBeginsAgain() {
    Player player = make();
    player.setSpeed(Player::unlimited);
    player.play();
    for (int i = 0; i < 10; ++i) QCOMPARE(frameAt(player, start), i);
    const auto end = player.poll(start, 0ms);
    QVERIFY(end && end->status == Status::End);
    QCOMPARE(player.status().state, PlayState::Ended);
    QVERIFY(!player.poll(start, 0ms));
    QCOMPARE(player.status().position, std::optional<std::size_t>(9));
    player.play();
    QCOMPARE(frameAt(player, start), 0);
  }

  void stepBackFromTheEndShowsTheFrameBeforeTheLast() {
    Player player = make();
    player.seek(9);
    QCOMPARE(frameAt(player, start), 9);
    player.step(1);
    QVERIFY(player.poll(start, 0ms)->status == Status::End);
    player.step(-1);
    QCOMPARE(frameAt(player, start), 8);
    QCOMPARE(player.status().state, PlayState::Paused);
  }

  void loopGoesRoundWithoutAnEnd() {
    Player player = make();
    player.setLoop(true);
    player.setSpeed(Player::unlimited);
    player.play();
    for (int i = 0; i < 25; ++i) QCOMPARE(frameAt(player, start), i % 10);
  }

  void anEmptyRecordingEndsEvenWhenLooped() {
    test::Script script;
    script.info.frameCount = 0;
    Player player = make(script);
    player.setLoop(true);
    player.play();
    QVERIFY(player.poll(start, 0ms)->status == Status::End);
    QVERIFY(!player.poll(start, 0ms));
  }

  void aBadFrameTakesItsTimeAndThePlayerGoesOn() {
    test::Script script;
    script.read = [](std::size_t i) -> ReadResult {
      if (i == 1) return {Status::Bad, nullptr, "torn", 0};
      return {Status::Ok, test::wallFrame(i, 0.1 * static_cast<double>(i)), {}, 0};
    };
    Player player = make(script);
    player.play();
    QCOMPARE(frameAt(player, start), 0);
    QVERIFY(!player.poll(start + 99ms, 0ms));
    const auto bad = player.poll(start + 100ms, 0ms);
    QVERIFY(bad && bad->status == Status::Bad);
    QCOMPARE(player.status().position, std::optional<std::size_t>(1));
    QCOMPARE(frameAt(player, start + 300ms), 2);
  }

  void aLiveSourceIsAlwaysDueAndCannotSeek() {
    test::Script script;
    script.info.live = true;
    script.info.frameCount.reset();
    Player player = make(script);
    player.play();
    for (int i = 0; i < 5; ++i) QCOMPARE(frameAt(player, start), i);
    QVERIFY(!player.seek(0));
    QVERIFY(*player.due() <= start);
  }

  void aLostSourceIsSaidOnceAndStaysLost() {
    test::Script script;
    script.info.live = true;
    script.read = [](std::size_t) -> ReadResult { return {Status::Lost, nullptr, "gone", 0}; };
    Player player = make(script);
    player.play();
    QVERIFY(player.poll(start, 0ms)->status == Status::Lost);
    player.play();
    player.step(1);
    QVERIFY(!player.poll(start, 0ms));
    QCOMPARE(player.status().state, PlayState::Lost);
  }
};

BOOMWATCH_TEST(TestPlayer)
#include "test_player.moc"
