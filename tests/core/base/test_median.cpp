#include <QtTest>
#include <algorithm>
#include <random>
#include <vector>

#include "base/median.h"
#include "support/test_registry.h"

using namespace boomwatch;

class TestMedian : public QObject {
  Q_OBJECT
 private slots:
  void ofAnEvenNumberItIsTheLargerOfTheTwoInTheMiddle() {
    QCOMPARE(medianOf(std::vector{3.0}), 3.0);
    QCOMPARE(medianOf(std::vector{2, 1}), 2);
    QCOMPARE(medianOf(std::vector{9.0F, 1.0F, 5.0F}), 5.0F);
    QCOMPARE(medianOf(std::vector{4, 1, 3, 2}), 3);
  }

  void isThatOfTheSortedValuesWhateverTheirNumber() {
    std::mt19937 random(1);
    for (std::size_t count = 1; count < 100; ++count) {
      std::vector<double> values(count);
      for (double& value : values) value = static_cast<double>(random() % 50);
      std::vector<double> sorted = values;
      std::ranges::sort(sorted);
      QCOMPARE(medianOf(values), sorted[count / 2]);
      std::ranges::sort(values);
      QCOMPARE(values, sorted);  // only their order has changed
    }
  }
};

BOOMWATCH_TEST(TestMedian)
#include "test_median.moc"
