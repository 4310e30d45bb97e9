#include <QtTest>

#include "load/log/learnt_length.h"
#include "support/test_registry.h"

using namespace boomwatch;

class TestLearntLength : public QObject {
  Q_OBJECT
 private slots:
  void isTheMedianOfTheLearningTime() {
    LearntLength length;
    QVERIFY(length.empty());
    for (const double seen : {3.0, 9.0, 2.9, 3.1, 0.5}) length.learn(seen, 0.8, true);
    QVERIFY(!length.empty());
    QCOMPARE(length.value(), 3.0);
  }

  void whatIsSeenClearlyBetterLaterTakesTheWorstOnesPlace() {
    LearntLength length;
    for (int k = 0; k < 3; ++k) length.learn(2.8, 0.3, true);
    length.learn(3.0, 0.35, false);  // hardly better
    length.learn(3.0, 0.1, false);   // worse
    QCOMPARE(length.value(), 2.8);
    length.learn(3.0, 0.9, false);
    QCOMPARE(length.value(), 2.8);  // one of three
    length.learn(3.0, 0.9, false);
    QCOMPARE(length.value(), 3.0);  // two of three
  }

  void belowTwelveDegreesOneViewIsAsGoodAsAnother() {
    LearntLength length;
    length.learn(2.0, 0.01, true);
    length.learn(3.0, 0.2, false);  // 20 times the sine, but neither angle is known
    QCOMPARE(length.value(), 2.0);
    length.learn(3.0, 0.25, false);
    QCOMPARE(length.value(), 3.0);
  }

  void nothingIsLearntLateIntoAnEmptyOne() {
    LearntLength length;
    length.learn(3.0, 0.9, false);
    QVERIFY(length.empty());
  }
};

BOOMWATCH_TEST(TestLearntLength)
#include "test_learnt_length.moc"
