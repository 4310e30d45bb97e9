#include <QtTest>

#include "distance_bar.h"
#include "support/baseline.h"
#include "support/compare_near.h"
#include "support/enumerators.h"
#include "support/scene_for_tests.h"
#include "support/test_registry.h"
#include "texts.h"
#include "theme.h"

using namespace boomwatch;

class TestDistanceBar : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void theBarBeginsAtTheCautionDistanceAndIsFullAtCollision_data();
  void theBarBeginsAtTheCautionDistanceAndIsFullAtCollision();
  void theRedInThePictureIsTheFill();
  void theNumberIsCutNeverRoundedUp();
  void everyReasonHasATitleAndARemedy();
  void withoutADistanceItIsHatchedAndSaysWhy();
  void nothingInRangeNamesTheRange();
  void nothingOnTheRaysNamesTheirLength();
  void whatWasNeverSeenIsSaid();
  void everythingThatIsWatchedIsListed();
  void theSizeNeverDependsOnTheNumber();
  void theLevelIsAnnounced();
  void aWorseLevelThatPassedUnseenIsShownOnce();
  void everyLevelIsToldApartWithoutColour();
};

namespace {

std::shared_ptr<Result> measured(double metres) {
  auto result = testing::makeResult();
  result->clearance.nearest->distance = metres;
  result->level = warningLevel(result->clearance, result->parameters.warning);
  return result;
}

std::shared_ptr<Result> unknown(Reason reason) {
  auto result = testing::makeResult();
  result->clearance = Clearance::unknown(reason);
  result->level = WarningLevel::NoDistance;
  return result;
}

/// Share of pixels of a colour in the column that goes through the middle of the bar.
double shareOf(const QImage& image, const QColor& colour, const QColor& other) {
  int hits = 0;
  int all = 0;
  for (int y = image.height() / 2; y < image.height(); ++y) {
    const QRgb pixel = image.pixel(40, y) | 0xff000000U;
    hits += pixel == colour.rgb();
    all += pixel == colour.rgb() || pixel == other.rgb();
  }
  return all > 0 ? static_cast<double>(hits) / all : -1.0;
}

}  // namespace

void TestDistanceBar::theBarBeginsAtTheCautionDistanceAndIsFullAtCollision_data() {
  QTest::addColumn<double>("metres");
  QTest::addColumn<double>("fill");
  QTest::newRow("far") << 3.7 << 0.0;
  QTest::newRow("caution") << 2.0 << 0.0;
  QTest::newRow("half") << 1.0 << 0.5;
  QTest::newRow("near") << 0.5 << 0.75;
  QTest::newRow("collision") << 0.0 << 1.0;
}

void TestDistanceBar::theBarBeginsAtTheCautionDistanceAndIsFullAtCollision() {
  QFETCH(double, metres);
  QFETCH(double, fill);
  DistanceBar bar;
  bar.setDisplay(makeDisplay(measured(metres), {}));
  QVERIFY(bar.fill());
  QCOMPARE(*bar.fill(), fill);
}

void TestDistanceBar::theRedInThePictureIsTheFill() {
  DistanceBar bar;
  bar.resize(176, 1000);
  const Theme theme = themeFor(bar.palette());
  // Low in the bar, so that the lower half of the picture holds nothing else.
  auto result = measured(1.8);
  bar.setDisplay(makeDisplay(result, {}));
  const QImage some = bar.grab().toImage();
  result = measured(1.6);
  bar.setDisplay(makeDisplay(result, {}));
  const QImage more = bar.grab().toImage();
  const double ratio =
      shareOf(more, theme.bar, theme.track) / shareOf(some, theme.bar, theme.track);
  BW_COMPARE_NEAR(ratio, 2.0, 0.05);
}

void TestDistanceBar::theNumberIsCutNeverRoundedUp() {
  DistanceBar bar;
  const std::vector<std::pair<double, const char*>> expected{{3.7, "3.70"},   {0.699, "0.69"},
                                                             {0.6, "0.60"},   {9.999, "9.99"},
                                                             {12.34, "12.3"}, {0.0, "0.00"}};
  for (const auto& [metres, text] : expected) {
    bar.setDisplay(makeDisplay(measured(metres), {}));
    QCOMPARE(bar.numberText(), QString(text));
  }
}

void TestDistanceBar::everyReasonHasATitleAndARemedy() {
  QVERIFY(reasonText(Reason::None).isEmpty() && reasonTitle(Reason::None).isEmpty());
  QStringList seen;
  // A sentence says what to do, and begins with a verb that says it.
  static const QRegularExpression remedy(
      "[.] "
      "(Check|Hold|Keep|Bring|Draw|Turn|Move|Widen|Track|Wait|Raise|Lower|Reopen|Select|Set|Show)"
      " ");
  for (const Reason reason : everyFault()) {
    QVERIFY2(!reasonTitle(reason).isEmpty(), std::string(toString(reason)).c_str());
    QVERIFY2(reasonText(reason).contains(remedy), qPrintable(reasonText(reason)));
    QVERIFY(!seen.contains(reasonText(reason)));
    seen << reasonText(reason);
  }
}

void TestDistanceBar::withoutADistanceItIsHatchedAndSaysWhy() {
  DistanceBar bar;
  bar.resize(bar.sizeHint());
  QVERIFY(!bar.fill());
  QVERIFY(bar.level() == WarningLevel::NoDistance);
  for (const Reason reason : everyFault()) {
    bar.setDisplay(makeDisplay(unknown(reason), {}));
    QVERIFY(!bar.fill());
    QVERIFY(bar.hintText().contains(reasonText(reason)));
    QVERIFY(!bar.numberText().contains(QRegularExpression("[0-9]")));
  }
  const Theme theme = themeFor(bar.palette());
  QVERIFY(shareOf(bar.grab().toImage(), theme.hatchLight, theme.hatchDark) > 0.2);
  bar.setDisplay(makeDisplay(measured(1.0), {}));
  QCOMPARE(shareOf(bar.grab().toImage(), theme.hatchLight, theme.hatchDark), -1.0);
}

void TestDistanceBar::nothingInRangeNamesTheRange() {
  auto result = testing::makeResult();
  result->clearance.state = ClearanceState::NothingInRange;
  result->clearance.nearest.reset();
  result->parameters.clearance.range = 8.0;
  result->level = WarningLevel::Clear;
  DistanceBar bar;
  bar.setDisplay(makeDisplay(result, {}));
  QCOMPARE(bar.numberText(), QString("> 8"));
  QVERIFY(bar.hintText().contains("no obstacle within 8 m"));
  QCOMPARE(*bar.fill(), 0.0);
}

void TestDistanceBar::nothingOnTheRaysNamesTheirLength() {
  auto result = testing::makeResult();
  result->clearance.state = ClearanceState::NothingInRange;
  result->clearance.nearest.reset();
  result->parameters.clearance.method = ClearanceMethod::Rays;  // 70 cells of 0.04 m
  DistanceBar bar;
  bar.setDisplay(makeDisplay(result, {}));
  QCOMPARE(bar.numberText(), QString("> 2.8"));
}

void TestDistanceBar::whatWasNeverSeenIsSaid() {
  auto result = measured(1.0);
  DistanceBar bar;
  bar.setDisplay(makeDisplay(result, {}));
  QVERIFY(bar.hintText().contains("17 %"));
  result = measured(1.0);
  result->clearance.observedShare = 0.9999;
  bar.setDisplay(makeDisplay(result, {}));
  QVERIFY(bar.hintText().contains("1 %"));
  result = measured(1.0);
  result->clearance.observedShare = 1.0;
  bar.setDisplay(makeDisplay(result, {}));
  QVERIFY(!bar.hintText().contains("unobserved"));
}

void TestDistanceBar::everythingThatIsWatchedIsListed() {
  auto result = measured(1.0);
  const auto watched = [&](WatchedObject object, int segment, double distance) {
    Watched one{object, segment, {}, result->clearance};
    one.clearance.nearest->distance = distance;
    return one;
  };
  result->watched = {watched(WatchedObject::Load, 0, 1.0), watched(WatchedObject::Tool, 0, 1.25),
                     watched(WatchedObject::Boom, 1, 4.5), watched(WatchedObject::Boom, 2, 3.5)};
  result->watched.push_back({WatchedObject::Boom, 3, {}, Clearance::unknown(Reason::ToolNotSeen)});
  DistanceBar bar;
  bar.setDisplay(makeDisplay(result, {}));
  // Below the number what leads and the nearest of each other kind, in the tooltip all.
  for (const double distance : {1.25, 3.5}) QVERIFY(bar.hintText().contains(metresText(distance)));
  QVERIFY(!bar.hintText().contains(metresText(4.5)));
  for (const Watched& one : result->watched) {
    QVERIFY2(bar.toolTip().contains(watchedDistance(one)), qPrintable(bar.toolTip()));
  }
  result = std::make_shared<Result>(*result);
  result->leading = 3;
  bar.setDisplay(makeDisplay(result, {}));
  QVERIFY(bar.hintText().contains(watchedText(result->watched[3])));
  QVERIFY(bar.hintText().contains(metresText(1.25)));
}

void TestDistanceBar::theSizeNeverDependsOnTheNumber() {
  DistanceBar bar;
  const QSize hint = bar.sizeHint();
  const QSize least = bar.minimumSizeHint();
  for (const auto& result : {measured(0.0), measured(999.0), unknown(Reason::NoModel)}) {
    bar.setDisplay(makeDisplay(result, {}));
    QCOMPARE(bar.sizeHint(), hint);
    QCOMPARE(bar.minimumSizeHint(), least);
  }
}

void TestDistanceBar::theLevelIsAnnounced() {
  DistanceBar bar;
  bar.setDisplay(makeDisplay(measured(0.5), {}));
  QVERIFY(bar.accessibleName().contains("0.50"));
  QVERIFY(bar.accessibleName().contains(levelText(WarningLevel::Warning)));
  bar.setDisplay(makeDisplay(unknown(Reason::NoLoad), {}));
  QVERIFY(bar.accessibleName().contains(reasonText(Reason::NoLoad)));
}

void TestDistanceBar::aWorseLevelThatPassedUnseenIsShownOnce() {
  DistanceBar bar;
  bar.setDisplay(makeDisplay(measured(1.5), {}));
  QVERIFY(bar.level() == WarningLevel::Caution);
  bar.setLatchedLevel(WarningLevel::Collision);
  QVERIFY(bar.level() == WarningLevel::Collision);
  bar.setDisplay(makeDisplay(measured(1.5), {}));
  QVERIFY(bar.level() == WarningLevel::Caution);
}

void TestDistanceBar::everyLevelIsToldApartWithoutColour() {
  DistanceBar bar;
  bar.resize(bar.sizeHint());
  bar.setDisplay(makeDisplay(measured(1.0), {}));
  QList<QImage> heads;
  for (const WarningLevel level : every<WarningLevel>()) {
    bar.setLatchedLevel(level);
    const QImage head =
        bar.grab(QRect(0, 0, 44, 46))
            .toImage()
            .convertToFormat(QImage::Format_Mono, Qt::ThresholdDither | Qt::AvoidDither);
    // At least an eighth of the shape's square is black where the other's is white, or the reverse.
    for (const QImage& other : heads) QVERIFY(differentPixels(head, other) > 26 * 26 / 8);
    heads << head;
  }
}

BOOMWATCH_TEST(TestDistanceBar)
#include "test_distance_bar.moc"
