#include <QtTest>

#include "lab/evaluation/track_score.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"
#include "support/tracked_target.h"
#include "tracking/tld_tracker.h"
#include "tracking/tool_model_file.h"

using namespace boomwatch;
using boomwatch::test::TargetScene;

/// TLD on a target whose place is known: it moves, grows, leaves, comes back, and has a double.
class TestTld : public QObject {
  Q_OBJECT
 private slots:
  void followsMotionAndScale();
  void findsAgainWhatLeft();
  void learningOffNeverChangesTheModel();
  void learningCanBeSwitchedWhileItRuns();
  void aDoubleSuspendsLearning();
  void findsFromAFileWithoutABox();
  void mergedModelsKnowBothViews();
  void oddImagesAreLostNotErrors();
  void anotherSizeIsLookedForAnew();
  void refusesAModelOfNothing();
  void saysTheSameTwice();

 private:
  const TargetScene m_scene;
};

namespace {

const cv::Point2d beginning(80.0, 90.0);

cv::Point2d placeAt(int frame) { return beginning + cv::Point2d(3.0 * frame, 1.0 * frame); }

TldTracker started(const TargetScene& scene) {
  TldTracker tracker;
  tracker.start(scene.image(beginning), TargetScene::box(beginning));
  return tracker;
}

/// Started, and taught by twenty images.
TldTracker trained(const TargetScene& scene, double angle = 0.0) {
  TldTracker tracker;
  tracker.start(scene.image(beginning, angle), TargetScene::box(beginning));
  for (int frame = 1; frame <= 20; ++frame) tracker.track(scene.image(placeAt(frame), angle));
  return tracker;
}

bool isAt(const Track& track, const cv::Rect2d& truth, double least = 0.6) {
  return track.box && overlapOf(*track.box, truth) >= least;
}

}  // namespace

void TestTld::followsMotionAndScale() {
  TldTracker tracker = started(m_scene);
  for (int frame = 1; frame <= 25; ++frame) {
    const double scale = 1.0 + 0.01 * frame;
    const Track track = tracker.track(m_scene.image(placeAt(frame), 0.0, scale));
    QCOMPARE(toString(track.state), toString(TrackState::Tracked));
    QVERIFY2(isAt(track, TargetScene::box(placeAt(frame), scale), 0.75),
             qPrintable(QString::number(frame)));
    QVERIFY(track.confidence > 0.5 && track.confidence <= 1.0);
  }
}

void TestTld::findsAgainWhatLeft() {
  TldTracker tracker = trained(m_scene);
  int boxes = 0;
  for (int frame = 0; frame < 40; ++frame) boxes += tracker.track(m_scene.wall()).box.has_value();
  QVERIFY2(boxes <= 26, qPrintable(QString::number(boxes)));  // doubt lasts a second at most
  QCOMPARE(toString(tracker.track(m_scene.wall()).state), toString(TrackState::Lost));
  const cv::Point2d elsewhere(230.0, 60.0);
  const Track track = tracker.track(m_scene.image(elsewhere));
  QCOMPARE(toString(track.state), toString(TrackState::Refound));
  QVERIFY(isAt(track, TargetScene::box(elsewhere)));
  QCOMPARE(toString(tracker.track(m_scene.image(elsewhere)).state), toString(TrackState::Tracked));
}

void TestTld::learningOffNeverChangesTheModel() {
  TldTracker tracker = started(m_scene);
  tracker.setLearning(false);
  const ToolModel before = *tracker.model();
  for (int frame = 1; frame <= 15; ++frame) {
    const Track track = tracker.track(m_scene.image(placeAt(frame), 2.0 * frame));
    QCOMPARE(toString(track.learning), toString(LearningState::Off));
  }
  tracker.track(m_scene.wall());
  QVERIFY(*tracker.model() == before);
}

void TestTld::learningCanBeSwitchedWhileItRuns() {
  TldTracker tracker = started(m_scene);
  const ToolModel before = *tracker.model();
  QCOMPARE(toString(tracker.track(m_scene.image(placeAt(1))).learning),
           toString(LearningState::On));
  QVERIFY(!(*tracker.model() == before));
  tracker.setLearning(false);
  const auto taught = tracker.model();
  tracker.track(m_scene.image(placeAt(2)));
  QVERIFY(*tracker.model() == *taught);
  tracker.setLearning(true);
  tracker.track(m_scene.image(placeAt(3)));
  QVERIFY(!(*tracker.model() == *taught));
}

void TestTld::aDoubleSuspendsLearning() {
  TldTracker tracker = trained(m_scene);
  const auto before = tracker.model();
  const cv::Point2d other(60.0, 180.0);
  for (int frame = 0; frame < 5; ++frame) {
    cv::Mat image = m_scene.image(placeAt(20));
    const cv::Rect place = TargetScene::box(other);
    m_scene.image(other)(place).copyTo(image(place));
    const Track track = tracker.track(image);
    QCOMPARE(toString(track.learning), toString(LearningState::Suspended));
  }
  QVERIFY(*tracker.model() == *before);
}

void TestTld::findsFromAFileWithoutABox() {
  const TemporaryFolder folder;
  const std::string file = folder.path("tool.model").string();
  saveToolModel(*trained(m_scene).model(), file);
  const ToolModel model = loadToolModel(file);
  TldTracker tracker;
  tracker.setLearning(false);
  tracker.start(model);
  QCOMPARE(toString(tracker.track(m_scene.wall()).state), toString(TrackState::Lost));
  const cv::Point2d elsewhere(200.0, 150.0);
  QVERIFY(isAt(tracker.track(m_scene.image(elsewhere)), TargetScene::box(elsewhere)));
  QVERIFY(*tracker.model() == model);
}

void TestTld::mergedModelsKnowBothViews() {
  // A quarter turn shows another picture in the same box.
  const std::vector<ToolModel> views = {*trained(m_scene).model(), *trained(m_scene, 90.0).model()};
  const cv::Point2d elsewhere(200.0, 150.0);
  const auto finds = [&](const ToolModel& model, double angle) {
    TldTracker tracker;
    tracker.start(model);
    return isAt(tracker.track(m_scene.image(elsewhere, angle)), TargetScene::box(elsewhere));
  };
  QVERIFY(!finds(views[0], 90.0));
  QVERIFY(!finds(views[1], 0.0));
  const ToolModel both = mergeToolModels(views);
  QVERIFY(finds(both, 0.0));
  QVERIFY(finds(both, 90.0));
}

void TestTld::oddImagesAreLostNotErrors() {
  const cv::Mat picture = m_scene.image(placeAt(1));
  cv::Mat wide;
  picture.convertTo(wide, CV_16U);
  const std::vector<cv::Mat> odd = {cv::Mat(), cv::Mat::zeros(picture.size(), CV_8UC3),
                                    cv::Mat::zeros(picture.size(), CV_8UC1),
                                    cv::Mat(1, 1, CV_8UC1, cv::Scalar(9)), wide};
  TldTracker tracker = started(m_scene);
  for (const cv::Mat& image : odd) {
    QCOMPARE(toString(TldTracker().track(image).state), toString(TrackState::Idle));
    const Track track = tracker.track(image);
    QCOMPARE(toString(track.state), toString(TrackState::Lost));
    QVERIFY(!track.box);
    QCOMPARE(track.confidence, 0.0);
    QVERIFY(isAt(tracker.track(picture), TargetScene::box(placeAt(1))));
  }
  QVERIFY(isAt(tracker.track(greyOf(picture)), TargetScene::box(placeAt(1))));
}

void TestTld::anotherSizeIsLookedForAnew() {
  TldTracker tracker = trained(m_scene);
  cv::Mat larger;
  cv::resize(m_scene.image(placeAt(20)), larger, {}, 1.5, 1.5);
  const Track track = tracker.track(larger);
  const cv::Rect2d there = TargetScene::box(placeAt(20));
  QVERIFY(isAt(track, {there.tl() * 1.5, there.size() * 1.5}));
}

void TestTld::refusesAModelOfNothing() {
  TldTracker tracker = started(m_scene);
  COMPARE_CONTAINS(errorOf([&] { tracker.start(ToolModel()); }), "nothing of a tool");
  ToolModel wrong = *tracker.model();
  wrong.positives.front() = cv::Mat::zeros(3, 3, CV_8UC1);
  COMPARE_CONTAINS(errorOf([&] { tracker.start(wrong); }), "nothing of a tool");
  const cv::Mat flat(240, 320, CV_8UC1, cv::Scalar(90));
  COMPARE_CONTAINS(errorOf([&] { tracker.start(flat, {10, 10, 50, 50}); }), "nothing in it");
  QVERIFY(isAt(tracker.track(m_scene.image(placeAt(1))), TargetScene::box(placeAt(1))));
}

void TestTld::saysTheSameTwice() {
  TldTracker one = started(m_scene);
  TldTracker other = started(m_scene);
  for (int frame = 1; frame <= 10; ++frame) {
    const cv::Mat image = m_scene.image(placeAt(frame), 3.0 * frame);
    const Track first = one.track(image);
    const Track second = other.track(image);
    QVERIFY(first.box == second.box);
    QCOMPARE(first.confidence, second.confidence);
  }
  QVERIFY(*one.model() == *other.model());
}

BOOMWATCH_TEST(TestTld)
#include "test_tld.moc"
