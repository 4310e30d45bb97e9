#include <QtTest>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "lab/evaluation/track_score.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"
#include "support/tracked_target.h"
#include "tracking/make_tracker.h"
#include "tracking/tool_model.h"
#include "tracking/tracker.h"

using namespace boomwatch;
using boomwatch::test::TargetScene;

Q_DECLARE_METATYPE(boomwatch::TrackerKind)
Q_DECLARE_METATYPE(cv::Rect2d)

/// What every kind of tracker promises; and what klt and csrt do beyond it.
class TestTrackers : public QObject {
  Q_OBJECT
 private slots:
  void manualIsNoTracker();
  void followsATargetThatMoves_data() { kinds(); }
  void followsATargetThatMoves();
  void refusesABoxThatHoldsNothing_data();
  void refusesABoxThatHoldsNothing();
  void aRefusedStartChangesNothing_data() { kinds(); }
  void aRefusedStartChangesNothing();
  void idleBeforeStart_data() { kinds(); }
  void idleBeforeStart();
  void oddImagesAreLostNotErrors_data();
  void oddImagesAreLostNotErrors();
  void greyAndColourMix_data() { kinds(); }
  void greyAndColourMix();
  void kltFollowsScale();
  void kltStaysLost();
  void csrtFindsAgainWhereItWas();
  void whatIsRejectedIsLookedForAgain_data();
  void whatIsRejectedIsLookedForAgain();
  void onlyTldHasAModel();

 private:
  static void kinds() {
    QTest::addColumn<TrackerKind>("kind");
    QTest::newRow("klt") << TrackerKind::Klt;
    QTest::newRow("csrt") << TrackerKind::Csrt;
    QTest::newRow("cmt") << TrackerKind::Cmt;
  }
  const TargetScene m_scene;
};

namespace {

const cv::Point2d beginning(100.0, 100.0);
const std::initializer_list<std::pair<const char*, TrackerKind>> namedKinds{
    {"klt", TrackerKind::Klt}, {"csrt", TrackerKind::Csrt}, {"cmt", TrackerKind::Cmt}};

std::unique_ptr<Tracker> started(TrackerKind kind, const TargetScene& scene) {
  auto tracker = makeTracker(kind);
  tracker->start(scene.image(beginning), TargetScene::box(beginning));
  return tracker;
}

}  // namespace

void TestTrackers::manualIsNoTracker() { QVERIFY(!makeTracker(TrackerKind::Manual)); }

void TestTrackers::followsATargetThatMoves() {
  QFETCH(TrackerKind, kind);
  const auto tracker = started(kind, m_scene);
  for (int frame = 1; frame <= 30; ++frame) {
    const cv::Point2d centre = beginning + cv::Point2d(3.3 * frame, 1.7 * frame);
    const Track track = tracker->track(m_scene.image(centre));
    QCOMPARE(toString(track.state), toString(TrackState::Tracked));
    QVERIFY2(overlapOf(*track.box, TargetScene::box(centre)) > 0.8,
             qPrintable(QString::number(frame)));
    QVERIFY(track.confidence > 0.4 && track.confidence <= 1.0);
    QCOMPARE(toString(track.learning), toString(LearningState::None));
  }
}

void TestTrackers::refusesABoxThatHoldsNothing_data() {
  QTest::addColumn<TrackerKind>("kind");
  QTest::addColumn<cv::Rect2d>("box");
  QTest::addColumn<bool>("flat");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [name, kind] : namedKinds) {
    const auto row = [&](const char* fault, const cv::Rect2d& box, bool flat) {
      QTest::addRow("%s: %s", name, fault) << kind << box << flat;
    };
    row("empty", {100, 100, 0, 0}, false);
    row("one pixel", {100, 100, 1, 1}, false);
    row("outside", {400, 100, 50, 50}, false);
    row("across the edge", {300, 100, 50, 50}, false);
    row("not finite", {nan, 100, 50, 50}, false);
    row("negative size", {100, 100, -50, -50}, false);
    row("without texture", {100, 100, 50, 50}, true);
  }
}

void TestTrackers::refusesABoxThatHoldsNothing() {
  QFETCH(TrackerKind, kind);
  QFETCH(cv::Rect2d, box);
  QFETCH(bool, flat);
  const auto tracker = makeTracker(kind);
  const cv::Mat image =
      flat ? cv::Mat(m_scene.wall().size(), CV_8UC3, cv::Scalar::all(90)) : m_scene.wall();
  QVERIFY(errorOf([&] { tracker->start(image, box); }).startsWith("tool box"));
  QVERIFY(errorOf([&] { tracker->start(cv::Mat(), box); }).startsWith("tool box"));
  QCOMPARE(toString(tracker->track(m_scene.wall()).state), toString(TrackState::Idle));
}

void TestTrackers::aRefusedStartChangesNothing() {
  QFETCH(TrackerKind, kind);
  const auto tracker = started(kind, m_scene);
  QVERIFY(!errorOf([&] { tracker->start(m_scene.wall(), {0, 0, 1, 1}); }).isEmpty());
  QCOMPARE(toString(tracker->track(m_scene.image(beginning)).state), toString(TrackState::Tracked));
}

void TestTrackers::idleBeforeStart() {
  QFETCH(TrackerKind, kind);
  const Track track = makeTracker(kind)->track(m_scene.wall());
  QCOMPARE(toString(track.state), toString(TrackState::Idle));
  QVERIFY(!track.box);
}

void TestTrackers::oddImagesAreLostNotErrors_data() {
  QTest::addColumn<TrackerKind>("kind");
  QTest::addColumn<int>("rows");
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("type");
  for (const auto& [name, kind] : namedKinds) {
    QTest::addRow("%s: empty", name) << kind << 0 << 0 << CV_8UC3;
    QTest::addRow("%s: black", name) << kind << 240 << 320 << CV_8UC3;
    QTest::addRow("%s: one pixel", name) << kind << 1 << 1 << CV_8UC3;
    QTest::addRow("%s: smaller", name) << kind << 120 << 160 << CV_8UC3;
    QTest::addRow("%s: larger", name) << kind << 480 << 640 << CV_8UC1;
    QTest::addRow("%s: 16 bits", name) << kind << 240 << 320 << CV_16UC1;
    QTest::addRow("%s: four channels", name) << kind << 240 << 320 << CV_8UC4;
  }
}

void TestTrackers::oddImagesAreLostNotErrors() {
  QFETCH(TrackerKind, kind);
  QFETCH(int, rows);
  QFETCH(int, columns);
  QFETCH(int, type);
  const auto tracker = started(kind, m_scene);
  for (int frame = 0; frame < 3; ++frame) {
    const Track track = tracker->track(cv::Mat::zeros(rows, columns, type));
    QCOMPARE(toString(track.state), toString(TrackState::Lost));
    QVERIFY(!track.box);
    QCOMPARE(track.confidence, 0.0);
  }
  // What comes after it is looked at again: no exception, and a state that fits its box.
  const Track after = tracker->track(m_scene.image(beginning));
  QCOMPARE(after.box.has_value(), after.state != TrackState::Lost);
}

void TestTrackers::greyAndColourMix() {
  QFETCH(TrackerKind, kind);
  const auto tracker = started(kind, m_scene);
  for (int frame = 1; frame <= 6; ++frame) {
    const cv::Point2d centre = beginning + cv::Point2d(2.0 * frame, 0.0);
    const cv::Mat image = m_scene.image(centre);
    const Track track = tracker->track(frame % 2 == 1 ? greyOf(image) : image);
    QVERIFY(track.box);
    QVERIFY(overlapOf(*track.box, TargetScene::box(centre)) > 0.7);
  }
}

void TestTrackers::kltFollowsScale() {
  const auto tracker = started(TrackerKind::Klt, m_scene);
  for (int frame = 1; frame <= 25; ++frame) {
    const double scale = std::pow(1.02, frame);
    const Track track = tracker->track(m_scene.image(beginning, 0.0, scale));
    QVERIFY(track.box);
    QVERIFY(overlapOf(*track.box, TargetScene::box(beginning, scale)) > 0.8);
  }
}

void TestTrackers::kltStaysLost() {
  const auto tracker = started(TrackerKind::Klt, m_scene);
  QCOMPARE(toString(tracker->track(cv::Mat::zeros(240, 320, CV_8UC3)).state),
           toString(TrackState::Lost));
  for (int frame = 0; frame < 3; ++frame) {
    QCOMPARE(toString(tracker->track(m_scene.image(beginning)).state), toString(TrackState::Lost));
  }
  tracker->start(m_scene.image(beginning), TargetScene::box(beginning));
  QCOMPARE(toString(tracker->track(m_scene.image(beginning)).state), toString(TrackState::Tracked));
}

void TestTrackers::whatIsRejectedIsLookedForAgain() {
  QFETCH(TrackerKind, kind);
  QFETCH(bool, findsAgain);
  const auto tracker = started(kind, m_scene);
  for (int k = 0; k < 10; ++k) {
    QVERIFY(tracker->track(m_scene.image(beginning + cv::Point2d(k, k))).box);
  }
  tracker->reject();
  Track after = tracker->track(m_scene.image(beginning));
  for (int k = 0; k < 5 && !after.box; ++k) after = tracker->track(m_scene.image(beginning));
  QCOMPARE(toString(after.state), toString(findsAgain ? TrackState::Refound : TrackState::Lost));
  QCOMPARE(after.box.has_value(), findsAgain);
  QCOMPARE(tracker->hasGivenUp(), !findsAgain);
  tracker->start(m_scene.image(beginning), TargetScene::box(beginning));
  QVERIFY(tracker->track(m_scene.image(beginning)).box);
  QVERIFY(!tracker->hasGivenUp());
}

void TestTrackers::whatIsRejectedIsLookedForAgain_data() {
  QTest::addColumn<TrackerKind>("kind");
  QTest::addColumn<bool>("findsAgain");
  QTest::newRow("tld") << TrackerKind::Tld << true;
  QTest::newRow("cmt") << TrackerKind::Cmt << true;
  QTest::newRow("klt") << TrackerKind::Klt << false;
  QTest::newRow("csrt") << TrackerKind::Csrt << false;
}

void TestTrackers::csrtFindsAgainWhereItWas() {
  const auto tracker = started(TrackerKind::Csrt, m_scene);
  QCOMPARE(toString(tracker->track(m_scene.image(beginning)).state), toString(TrackState::Tracked));
  QCOMPARE(toString(tracker->track(cv::Mat::zeros(240, 320, CV_8UC3)).state),
           toString(TrackState::Lost));
  const Track again = tracker->track(m_scene.image(beginning));
  QCOMPARE(toString(again.state), toString(TrackState::Refound));
  QVERIFY(overlapOf(*again.box, TargetScene::box(beginning)) > 0.7);
  QCOMPARE(toString(tracker->track(m_scene.image(beginning)).state), toString(TrackState::Tracked));
}

void TestTrackers::onlyTldHasAModel() {
  for (const auto& [name, kind] : namedKinds) {
    const auto tracker = started(kind, m_scene);
    QVERIFY(!tracker->model());
    tracker->setLearning(true);
    QVERIFY(errorOf([&] { tracker->start(ToolModel{}); }).startsWith("tracker"));
  }
}

BOOMWATCH_TEST(TestTrackers)
#include "test_trackers.moc"
