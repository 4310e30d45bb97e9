#include <QtTest>

#include "lab/evaluation/track_score.h"
#include "support/striped_target.h"
#include "support/test_registry.h"
#include "tracking/colour_layout.h"
#include "tracking/tld_tracker.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

const cv::Point begin(60, 80), elsewhere(300, 220);
constexpr int observed = 10;

/// It has seen the target go a little.
ColourLayout experienced(const StripedTarget& target) {
  ColourLayout colours;
  colours.begin(target.image(begin), StripedTarget::box(begin));
  for (int k = 1; k <= observed; ++k) {
    const cv::Point at = begin + cv::Point(3 * k, k);
    const cv::Mat image = target.image(at);
    colours.observe(image, colours.places(image), StripedTarget::box(at));
  }
  return colours;
}

std::optional<ColourLayout::Place> foundIn(const ColourLayout& colours, const cv::Mat& image) {
  return colours.toolIn(image, colours.places(image));
}

TldTracker started(const StripedTarget& target) {
  TldTracker tracker;
  tracker.start(target.image(begin), StripedTarget::box(begin));
  return tracker;
}

/// Tracked for 60 images, then away for ten.
TldTracker leftBy(const StripedTarget& target, TldTracker tracker) {
  for (int k = 1; k <= 60; ++k) tracker.track(target.image(begin + cv::Point(k, k / 4)));
  const cv::Mat nothing = texture({480, 360}, 3.0, 1);
  for (int k = 0; k < 10; ++k) tracker.track(nothing);
  return tracker;
}

/// The target has turned, and beside it is a thing that differs by its colours alone.
cv::Mat beside(StripedTarget target) {
  target.turned = true;
  cv::Mat image = target.image(elsewhere);
  target.above = target.below = cv::Scalar(90, 90, 90);
  target.drawInto(image, {100, 240});
  return image;
}

Track lastOf(TldTracker& tracker, const cv::Mat& image, int images) {
  Track track;
  for (int k = 0; k < images; ++k) track = tracker.track(image);
  return track;
}

}  // namespace

/// What the colours say where patches and keypoints do not know the tool any more.
class TestColourLayout : public QObject {
  Q_OBJECT
 private slots:
  void findsATargetThatTurned();
  void saysNothingWithoutExperience();
  void saysNothingOfOtherColours();
  void saysNothingWhereTwoAreAlike();
  void saysNothingWhereItWasWrong();
  void oddImagesAreHarmless();
  void theTrackerFindsATargetThatTurned();
  void aTrackerWithASavedModelLearnsThemToo();
  void theTrackerDoesNotTakeOtherColours();
};

void TestColourLayout::findsATargetThatTurned() {
  StripedTarget target;
  const ColourLayout colours = experienced(target);
  target.turned = true;
  const cv::Mat image = target.image(elsewhere);
  const auto found = foundIn(colours, image);
  QVERIFY(found);
  QVERIFY(overlapOf(found->box, StripedTarget::box(elsewhere)) > 0.7);
  QVERIFY(!colours.denies(image, StripedTarget::box(elsewhere)));
  QVERIFY(colours.denies(image, StripedTarget::box(begin)));
}

void TestColourLayout::saysNothingWithoutExperience() {
  const StripedTarget target;
  ColourLayout colours;
  QVERIFY(colours.places(target.image(begin)).empty());
  QCOMPARE(colours.scoreOf(target.image(begin), StripedTarget::box(begin)), -1.0);
  colours.begin(target.image(begin), StripedTarget::box(begin));
  QVERIFY(colours.scoreOf(target.image(begin), StripedTarget::box(begin)) > 0.99);
  QVERIFY(!colours.threshold());
  QVERIFY(!foundIn(colours, target.image(begin)));
}

void TestColourLayout::saysNothingOfOtherColours() {
  StripedTarget target;
  const ColourLayout colours = experienced(target);
  std::swap(target.above, target.below);
  QVERIFY(!foundIn(colours, target.image(elsewhere)));
  QVERIFY(colours.denies(target.image(elsewhere), StripedTarget::box(elsewhere)));
}

void TestColourLayout::saysNothingWhereTwoAreAlike() {
  const StripedTarget target;
  const ColourLayout colours = experienced(target);
  cv::Mat image = target.image(begin);
  const cv::Size size(StripedTarget::side, StripedTarget::side);
  image(cv::Rect(begin, size)).copyTo(image(cv::Rect(elsewhere, size)));
  QVERIFY(!foundIn(colours, image));
}

void TestColourLayout::saysNothingWhereItWasWrong() {
  const StripedTarget target;
  ColourLayout colours = experienced(target);
  const cv::Mat image = target.image(elsewhere);
  QVERIFY(foundIn(colours, image));
  for (int k = 0; k < 2; ++k) {
    colours.observe(image, colours.places(image), StripedTarget::box(begin));
  }
  QVERIFY(!colours.threshold());
  QVERIFY(!foundIn(colours, image));
}

void TestColourLayout::oddImagesAreHarmless() {
  const StripedTarget target;
  const ColourLayout colours = experienced(target);
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 300), cv::Size(40, 40)}) {
    for (const int type : {CV_8UC1, CV_8UC3}) {
      const cv::Mat black = cv::Mat::zeros(size, type);
      QVERIFY(!foundIn(colours, black));
      QVERIFY(colours.scoreOf(black, {-5, -5, 20, 20}) < 0.5);
    }
  }
  const cv::Mat image = target.image(begin);
  QCOMPARE(colours.scoreOf(image, {1e6, 1e6, 60, 60}), -1.0);
  ColourLayout outside;
  outside.begin(image, {-100, -100, 60, 60});
  QVERIFY(outside.places(image).empty());
}

void TestColourLayout::theTrackerFindsATargetThatTurned() {
  const StripedTarget target;
  TldTracker tracker = leftBy(target, started(target));
  const Track track = lastOf(tracker, beside(target), 15);
  QVERIFY(track.box);
  QVERIFY(overlapOf(*track.box, StripedTarget::box(elsewhere)) > 0.5);
}

void TestColourLayout::aTrackerWithASavedModelLearnsThemToo() {
  const StripedTarget target;
  const auto model = leftBy(target, started(target)).model();
  TldTracker fresh;
  fresh.start(*model);
  TldTracker tracker = leftBy(target, std::move(fresh));
  const Track track = lastOf(tracker, beside(target), 15);
  QVERIFY(track.box);
  QVERIFY(overlapOf(*track.box, StripedTarget::box(elsewhere)) > 0.5);
}

void TestColourLayout::theTrackerDoesNotTakeOtherColours() {
  StripedTarget target;
  TldTracker tracker = leftBy(target, started(target));
  std::swap(target.above, target.below);
  QVERIFY(!lastOf(tracker, target.image(elsewhere), 15).box);
}

BOOMWATCH_TEST(TestColourLayout)
#include "test_colour_layout.moc"
