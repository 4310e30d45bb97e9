#include "player_bar.h"
#include "support/test_registry.h"

#include <QAction>
#include <QComboBox>
#include <QSignalSpy>
#include <QSlider>
#include <QtTest>

using namespace boomwatch;

class TestPlayerBar : public QObject {
  Q_OBJECT

 private:
  static PlayerStatus recording(std::size_t position, std::size_t count) {
    PlayerStatus status;
    status.state = PlayState::Playing;
    status.position = position;
    status.count = count;
    return status;
  }
  static QAction* actionFor(const PlayerBar& bar, const QKeySequence& key) {
    for (QAction* action : bar.actions()) {
      if (action->shortcut() == key) return action;
    }
    return nullptr;
  }

 private slots:
  void everythingIsOffWhileNothingIsOpen() {
    PlayerBar bar;
    for (const QAction* action : bar.actions()) QVERIFY(!action->isEnabled());
    QVERIFY(!bar.findChild<QSlider*>()->isEnabled());
    QVERIFY(bar.stateText().isEmpty());
  }

  void positionIsCountedFromOne() {
    PlayerBar bar;
    bar.setStatus(recording(12, 400));
    QCOMPARE(bar.positionText(), QStringLiteral("13 / 400"));
    QCOMPARE(bar.findChild<QSlider*>()->value(), 12);
    QCOMPARE(bar.findChild<QSlider*>()->maximum(), 399);
  }

  void showingAStatusAsksForNothing() {
    PlayerBar bar;
    QSignalSpy seeks(&bar, &PlayerBar::seekRequested);
    QSignalSpy loops(&bar, &PlayerBar::loopChanged);
    QSignalSpy speeds(&bar, &PlayerBar::speedChanged);
    PlayerStatus status = recording(300, 400);
    status.loop = true;
    status.speed = Player::unlimited;
    bar.setStatus(status);
    bar.setStatus(recording(2, 5));
    QCOMPARE(seeks.count() + loops.count() + speeds.count(), 0);
  }

  void spacePlaysOrPauses() {
    PlayerBar bar;
    QSignalSpy plays(&bar, &PlayerBar::playRequested);
    QSignalSpy pauses(&bar, &PlayerBar::pauseRequested);
    PlayerStatus status = recording(2, 5);
    bar.setStatus(status);
    actionFor(bar, Qt::Key_Space)->trigger();
    QCOMPARE(pauses.count(), 1);
    status.state = PlayState::Paused;
    bar.setStatus(status);
    actionFor(bar, Qt::Key_Space)->trigger();
    QCOMPARE(plays.count(), 1);
  }

  void stepsAskForTheirDirection() {
    PlayerBar bar;
    QSignalSpy steps(&bar, &PlayerBar::stepRequested);
    bar.setStatus(recording(2, 5));
    actionFor(bar, Qt::Key_Period)->trigger();
    actionFor(bar, Qt::Key_Comma)->trigger();
    QCOMPARE(steps.count(), 2);
    QCOMPARE(steps[0][0].toInt(), 1);
    QCOMPARE(steps[1][0].toInt(), -1);
  }

  void theSliderSeeks() {
    PlayerBar bar;
    QSignalSpy seeks(&bar, &PlayerBar::seekRequested);
    bar.setStatus(recording(2, 50));
    bar.findChild<QSlider*>()->setValue(31);
    QCOMPARE(seeks.count(), 1);
    QCOMPARE(seeks[0][0].value<std::size_t>(), std::size_t(31));
  }

  void aSliderThatIsHeldIsNotPulledAway() {
    PlayerBar bar;
    bar.setStatus(recording(2, 50));
    auto* slider = bar.findChild<QSlider*>();
    slider->setSliderDown(true);
    slider->setValue(31);
    bar.setStatus(recording(3, 50));
    QCOMPARE(slider->value(), 31);
    slider->setSliderDown(false);
    bar.setStatus(recording(4, 50));
    QCOMPARE(slider->value(), 4);
  }

  void aLiveSourceHasNeitherSpeedNorPosition() {
    PlayerBar bar;
    PlayerStatus live;
    live.state = PlayState::Playing;
    live.live = true;
    live.position = 1233;
    bar.setStatus(live);
    QVERIFY(!bar.findChild<QSlider*>()->isEnabled());
    QVERIFY(!bar.findChild<QComboBox*>()->isEnabled());
    QVERIFY(!actionFor(bar, Qt::Key_Comma)->isEnabled());
    QCOMPARE(bar.positionText(), QStringLiteral("1234"));
  }

  void noTwoStatesReadAlike() {
    PlayerBar bar;
    QStringList texts;
    for (const auto state :
         {PlayState::Playing, PlayState::Paused, PlayState::Ended, PlayState::Lost}) {
      PlayerStatus status = recording(4, 5);
      status.state = state;
      bar.setStatus(status);
      QVERIFY(!bar.stateText().isEmpty());
      QVERIFY(!texts.contains(bar.stateText()));
      texts << bar.stateText();
    }
  }

  void sizeDoesNotDependOnTheNumbers() {
    PlayerBar bar;
    bar.setStatus(recording(0, 9));
    const QSize small = bar.minimumSizeHint();
    bar.setStatus(recording(123455, 999999));
    QCOMPARE(bar.minimumSizeHint(), small);
  }

  void speedsAreAskedForAsNumbers() {
    PlayerBar bar;
    QSignalSpy speeds(&bar, &PlayerBar::speedChanged);
    bar.setStatus(recording(0, 9));
    auto* box = bar.findChild<QComboBox*>();
    box->setCurrentIndex(0);
    emit box->activated(0);
    box->setCurrentIndex(box->count() - 1);
    emit box->activated(box->count() - 1);
    QCOMPARE(speeds[0][0].toDouble(), Player::slowest);
    QCOMPARE(speeds[1][0].toDouble(), Player::unlimited);
  }
};

BOOMWATCH_TEST(TestPlayerBar)
#include "test_player_bar.moc"
