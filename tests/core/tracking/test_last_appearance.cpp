#include <QtTest>

#include "lab/evaluation/track_score.h"
#include "support/test_registry.h"
#include "support/tracked_target.h"
#include "tracking/last_appearance.h"
#include "tracking/tracker.h"

using namespace boomwatch;
using namespace boomwatch::test;

class TestLastAppearance : public QObject {
  Q_OBJECT
 private slots:
  void findsWhatComesBack_data();
  void findsWhatComesBack();
  void notInTheFirstImages();
  void notWhatWasThereAllTheTime();
  void notWhatElseIsInItsPlace();
  void whatIsFollowedIsForgotten();
  void knowsWhatItLooksLike();
  void remembersNothingOfABoxThatShowsNothing();
  void theRimMayBeOutsideThePicture();
  void looksAtImagesOfAnySize();
};

namespace {

const TargetScene scene(20.0, 5.0);  // what is beside the target changes little with its place
const cv::Point2d place(150.0, 120.0);
constexpr int away = 12;  // images

cv::Mat withTarget(cv::Point2d centre, double angle = 0.0, double scale = 1.0) {
  return greyOf(scene.image(centre, angle, scale));
}

LastAppearance seenAt(cv::Point2d centre) {
  LastAppearance look;
  look.remember(withTarget(centre), TargetScene::box(centre));
  return look;
}

std::optional<cv::Rect2d> lastOf(LastAppearance& look, const cv::Mat& grey, int images) {
  std::optional<cv::Rect2d> found;
  for (int k = 0; k < images; ++k) found = look.find(grey);
  return found;
}

}  // namespace

void TestLastAppearance::findsWhatComesBack_data() {
  QTest::addColumn<QPointF>("shift");
  QTest::addColumn<double>("angle");
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("contrast");
  QTest::newRow("as it was") << QPointF() << 0.0 << 1.0 << 1.0;
  QTest::newRow("a little elsewhere") << QPointF(9, -5) << 0.0 << 1.0 << 1.0;
  QTest::newRow("turned a little, farther away") << QPointF(-2, 2) << 6.0 << 0.9 << 1.0;
  QTest::newRow("in other light") << QPointF(3, 0) << 0.0 << 1.0 << 0.4;
}

void TestLastAppearance::findsWhatComesBack() {
  QFETCH(QPointF, shift);
  QFETCH(double, angle);
  QFETCH(double, scale);
  QFETCH(double, contrast);
  LastAppearance look = seenAt(place);
  QVERIFY(!lastOf(look, greyOf(scene.wall()), away));
  const cv::Point2d centre = place + cv::Point2d(shift.x(), shift.y());
  cv::Mat back;
  withTarget(centre, angle, scale).convertTo(back, -1, contrast, 20.0);
  QVERIFY2(!look.find(back), "seen once");
  const auto found = look.find(back);
  QVERIFY(found);
  QVERIFY(overlapOf(*found, TargetScene::box(centre, scale)) > 0.75);
}

void TestLastAppearance::notInTheFirstImages() {
  LastAppearance look = seenAt(place);
  QVERIFY(!lastOf(look, greyOf(scene.wall()), 3));
  QVERIFY(!lastOf(look, withTarget(place), 3));
}

void TestLastAppearance::notWhatWasThereAllTheTime() {
  // A twin in the same surroundings: half of the picture is what the other half is.
  const auto twins = [](const cv::Mat& left, const cv::Mat& right) {
    cv::Mat both;
    cv::hconcat(left, right, both);
    return both;
  };
  const cv::Mat wall = greyOf(scene.wall()), target = withTarget(place);
  LastAppearance look;
  look.remember(twins(target, target), TargetScene::box(place));
  QVERIFY(!lastOf(look, twins(wall, target), 30));
  QVERIFY2(!lastOf(look, twins(target, target), 5), "which of them is it?");
}

void TestLastAppearance::notWhatElseIsInItsPlace() {
  LastAppearance look = seenAt(place);
  QVERIFY(!lastOf(look, withTarget(place, 90.0), away));
  QVERIFY(!lastOf(look, withTarget(place, 180.0), away));
}

void TestLastAppearance::whatIsFollowedIsForgotten() {
  LastAppearance look = seenAt(place);
  QVERIFY(!lastOf(look, withTarget(place), away));  // was there all the time
  look.follow();
  QVERIFY(!lastOf(look, greyOf(scene.wall()), away));
  QVERIFY(lastOf(look, withTarget(place), 2));
  look.forget();
  QVERIFY(!lastOf(look, greyOf(scene.wall()), away));
  QVERIFY(!lastOf(look, withTarget(place), 2));
}

void TestLastAppearance::knowsWhatItLooksLike() {
  const LastAppearance look = seenAt(place);
  QVERIFY(look.recognises(withTarget(place), TargetScene::box(place)));
  QVERIFY(!look.recognises(withTarget(place), TargetScene::box(place + cv::Point2d(25, 0))));
  QVERIFY(!look.recognises(greyOf(scene.wall()), TargetScene::box(place)));
  QVERIFY(!look.recognises(withTarget(place), TargetScene::box({310.0, 230.0})));
  QVERIFY(!LastAppearance().recognises(withTarget(place), TargetScene::box(place)));
}

void TestLastAppearance::remembersNothingOfABoxThatShowsNothing() {
  const cv::Mat grey = withTarget(place), even(240, 320, CV_8UC1, cv::Scalar(90));
  const auto keepsTheFirst = [&](const cv::Mat& image, const cv::Rect2d& box) {
    LastAppearance look = seenAt(place);
    look.remember(image, box);
    return look.recognises(grey, TargetScene::box(place));
  };
  QVERIFY(keepsTheFirst(grey, TargetScene::box(place)));
  QVERIFY(!keepsTheFirst(greyOf(scene.wall()), TargetScene::box(place)));
  QVERIFY(keepsTheFirst(grey, {400.0, 300.0, 80.0, 80.0}));
  QVERIFY(keepsTheFirst(grey, {-70.0, 100.0, 80.0, 80.0}));
  QVERIFY(keepsTheFirst(grey, {-15.0, 100.0, 80.0, 80.0}));
  QVERIFY(keepsTheFirst(grey, {100.0, 100.0, 2.0, 2.0}));
  QVERIFY(keepsTheFirst(grey, {100.0, 100.0, 300.0, 1.0}));
  QVERIFY(keepsTheFirst(grey, {}));
  QVERIFY(keepsTheFirst(even, TargetScene::box(place)));
}

void TestLastAppearance::theRimMayBeOutsideThePicture() {
  const cv::Point2d edge(42.0, 120.0);
  LastAppearance look = seenAt(edge);
  QVERIFY(!lastOf(look, greyOf(scene.wall()), away));
  const auto found = lastOf(look, withTarget(edge), 2);
  QVERIFY(found);
  QVERIFY(overlapOf(*found, TargetScene::box(edge)) > 0.9);
}

void TestLastAppearance::looksAtImagesOfAnySize() {
  LastAppearance look = seenAt(place);
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(640, 3), cv::Size(30, 30)}) {
    QVERIFY(!lastOf(look, cv::Mat(size, CV_8UC1, cv::Scalar(90)), away));
  }
  QVERIFY(!lastOf(look, greyOf(scene.wall()), away));
  QVERIFY(lastOf(look, withTarget(place), 2));
}

BOOMWATCH_TEST(TestLastAppearance)
#include "test_last_appearance.moc"
