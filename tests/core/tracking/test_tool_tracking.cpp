#include <QtTest>
#include <stdexcept>

#include "support/compare_near.h"
#include "support/test_registry.h"
#include "support/tool_stage.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

/// Names, so that a failed comparison says which.
template <class Enum>
QByteArray text(Enum value) {
  return QByteArray(toString(value).data());
}

const cv::Rect2d box(40, 60, 20, 24);  // its middle is (50, 72)

using Stage = ToolStage;

Track lostTrack(const cv::Mat&) { return Track::lost(); }

}  // namespace

class TestToolTracking : public QObject {
  Q_OBJECT
 private slots:
  void whatTheSourceOffersIsTakenUpOnce();
  void whatAPersonSaidIsNotOverruledByAnOffer();
  void idlesUntilItIsTold();
  void aClickStaysWhereItIs();
  void aBoxIsFollowedAndItsMiddleMeasured();
  void aBoxThatCannotBeFollowed_data();
  void aBoxThatCannotBeFollowed();
  void aRefusedBoxLeavesATrackerThatRunsAsItIs();
  void aModelIsLookedFor();
  void aModelForATrackerThatKeepsNone();
  void lostButNotForLong();
  void lostForLongerThanTheLimit();
  void anotherKindBeginsWhereTheOldOneLastSawIt();
  void anotherKindThatCannotBegin();
  void manualTakesTheBoxOver();
  void manualFollowsNothing();
  void againBeginsWithTheLastBox();
  void againWithoutAnythingSeen();
  void forgettingStopsIt();
  void learningIsPassedOn();
  void anExceptionOfATrackerIsALostTool();
  void blackEmptyAndOtherSizedImages();
  void noDepthUnderTheTool();
  void theBoxEndsTheSearchToTheRight();
  void nearLooksPastTheGapBetweenTines();
};

void TestToolTracking::whatTheSourceOffersIsTakenUpOnce() {
  Stage stage;
  stage.tracking.offer(box, TrackerKind::Manual);
  QVERIFY(!stage.tracking.needsImage());
  stage.tracking.offer(std::nullopt, TrackerKind::Tld);
  QVERIFY(!stage.tracking.needsImage());
  stage.tracking.offer(box, TrackerKind::Tld);
  QVERIFY(stage.frame().running());
  stage.tracking.offer(cv::Rect2d(1, 1, 30, 30), TrackerKind::Tld);
  stage.frame();
  QCOMPARE(stage.script->boxes, std::vector<cv::Rect2d>{box});
}

void TestToolTracking::whatAPersonSaidIsNotOverruledByAnOffer() {
  Stage stage;
  stage.tracking.order(ForgetTool{});
  stage.frame();
  stage.tracking.offer(box, TrackerKind::Tld);
  QVERIFY(!stage.frame().running());
  QVERIFY(stage.script->boxes.empty());
}

void TestToolTracking::idlesUntilItIsTold() {
  Stage stage;
  QVERIFY(!stage.tracking.needsImage());
  const ToolTrack tool = stage.frames(3);
  QVERIFY(!tool.running() && !tool.lost());
  QVERIFY(!tool.box && !tool.pixel && !tool.point && !tool.age && !tool.model);
  QVERIFY(stage.script->made.empty());
}

void TestToolTracking::aClickStaysWhereItIs() {
  Stage stage;
  stage.tracking.order(PickTool{{30, 40}});
  const ToolTrack tool = stage.frames(3);
  QVERIFY(!tool.running());
  QVERIFY(tool.pixel == std::optional(cv::Point(30, 40)));
  QCOMPARE(*tool.point, stage.cloud->at(30, 40));
  stage.tracking.order(ForgetTool{});
  QVERIFY(!stage.frame().pixel);
}

void TestToolTracking::aBoxIsFollowedAndItsMiddleMeasured() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  QVERIFY(stage.tracking.needsImage());
  const ToolTrack tool = stage.frames(4);
  QCOMPARE(text(tool.state), text(TrackState::Tracked));
  QVERIFY(tool.box == std::optional(box));
  QCOMPARE(tool.confidence, 0.8);
  QVERIFY(tool.pixel == std::optional(cv::Point(50, 72)));
  QVERIFY((*tool.point - stage.cloud->at(50, 72)).norm() < 0.01F);
  QVERIFY(tool.velocity->norm() < 0.05F);
  QCOMPARE(*tool.age, 0.0);
  QVERIFY(tool.model);
  QCOMPARE(stage.script->boxes.size(), std::size_t(1));
}

void TestToolTracking::aBoxThatCannotBeFollowed_data() {
  QTest::addColumn<QRectF>("drawn");
  QTest::newRow("empty") << QRectF(40, 40, 0, 0);
  QTest::newRow("one pixel") << QRectF(40, 40, 1, 1);
  QTest::newRow("outside") << QRectF(400, 400, 20, 20);
  QTest::newRow("reaches outside") << QRectF(150, 40, 20, 20);
  QTest::newRow("not a number") << QRectF(qQNaN(), 40, 20, 20);
}

void TestToolTracking::aBoxThatCannotBeFollowed() {
  QFETCH(QRectF, drawn);
  Stage stage;
  stage.tracking.order(TrackBox{{drawn.x(), drawn.y(), drawn.width(), drawn.height()}});
  const ToolTrack first = stage.frame();
  QVERIFY(!first.fault.empty());
  // Somebody wants the tool to be followed, and it is not.
  QVERIFY(first.lost());
  QCOMPARE(text(first.state), text(TrackState::Lost));
  const ToolTrack second = stage.frame();
  QVERIFY(second.fault.empty() && second.lost());
  stage.tracking.order(TrackBox{box});
  QVERIFY(!stage.frame().lost());
}

void TestToolTracking::aRefusedBoxLeavesATrackerThatRunsAsItIs() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.frames(3);
  stage.tracking.order(TrackBox{{150, 150, 40, 40}});
  const ToolTrack tool = stage.frame();
  QVERIFY(!tool.fault.empty());
  QVERIFY(tool.box == std::optional(box));
  QVERIFY(!tool.lost());
}

void TestToolTracking::aModelIsLookedFor() {
  Stage stage;
  stage.script->see = lostTrack;
  auto model = std::make_shared<ToolModel>();
  model->size = {30, 20};
  stage.tracking.order(TrackModel{model});
  const ToolTrack searching = stage.frame();
  QVERIFY(searching.lost() && !searching.age && searching.fault.empty());
  stage.script->see = [](const cv::Mat&) {
    return Track{TrackState::Refound, box, 0.9, LearningState::Off};
  };
  const ToolTrack found = stage.frame();
  QCOMPARE(text(found.state), text(TrackState::Refound));
  QCOMPARE(text(found.learning), text(LearningState::Off));
  QVERIFY(!found.lost());
  QCOMPARE(stage.script->modelStarts.size(), std::size_t(1));
}

void TestToolTracking::aModelForATrackerThatKeepsNone() {
  Stage stage;
  stage.script->keepsModel = false;
  stage.parameters.tracker = TrackerKind::Klt;
  stage.tracking.order(TrackModel{std::make_shared<ToolModel>()});
  const ToolTrack tool = stage.frame();
  QVERIFY(tool.fault.find("tld") != std::string::npos);
  QVERIFY(tool.lost());
}

void TestToolTracking::lostButNotForLong() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  const ToolTrack seen = stage.frames(5);
  stage.script->see = lostTrack;
  const ToolTrack tool = stage.frames(4);
  QCOMPARE(text(tool.state), text(TrackState::Lost));
  QVERIFY(!tool.box && !tool.pixel);
  QCOMPARE(tool.confidence, 0.0);
  QVERIFY(!tool.lost());
  QVERIFY((*tool.point - *seen.point).norm() < 0.05F);
  BW_COMPARE_NEAR(*tool.age, 0.4, 1e-9);
}

void TestToolTracking::lostForLongerThanTheLimit() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.frames(5);
  stage.script->see = lostTrack;
  const ToolTrack tool = stage.frames(6);
  QVERIFY(tool.lost());
  QVERIFY(!tool.point && !tool.velocity);
  BW_COMPARE_NEAR(*tool.age, 0.6, 1e-9);
  stage.script->see = nullptr;
  QVERIFY(!stage.frame().lost());
}

void TestToolTracking::anotherKindBeginsWhereTheOldOneLastSawIt() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  const cv::Rect2d later(90, 100, 20, 24);
  stage.script->see = [&](const cv::Mat&) {
    return Track{TrackState::Tracked, later, 1.0, LearningState::On};
  };
  stage.frame();
  stage.image = texture({160, 160}, 2);
  stage.frame();
  const cv::Mat lastSeen = stage.image;
  stage.script->see = lostTrack;
  stage.image = texture({160, 160}, 4);
  stage.frame();
  stage.parameters.tracker = TrackerKind::Csrt;
  stage.frame();
  QVERIFY((stage.script->made == std::vector{TrackerKind::Tld, TrackerKind::Csrt}));
  QVERIFY(stage.script->boxes.back() == later);
  // In the picture in which it was seen, not in a later one.
  QVERIFY(stage.script->startImages.back().data == lastSeen.data);
  stage.script->see = nullptr;
  QVERIFY(stage.frame().box == std::optional(later));
}

void TestToolTracking::anotherKindThatCannotBegin() {
  Stage stage;
  stage.script->see = lostTrack;
  stage.tracking.order(TrackModel{std::make_shared<ToolModel>()});
  stage.frame();
  stage.script->keepsModel = false;
  stage.parameters.tracker = TrackerKind::Klt;
  QVERIFY(!stage.frame().fault.empty());
  const ToolTrack tool = stage.frame();
  QVERIFY(tool.fault.empty() && tool.lost());
}

void TestToolTracking::manualTakesTheBoxOver() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.frames(2);
  stage.parameters.tracker = TrackerKind::Manual;
  const ToolTrack tool = stage.frame();
  QVERIFY(!tool.running());
  QVERIFY(tool.pixel == std::optional(cv::Point(50, 72)));
  // Back again there is no box: nothing runs until one is drawn.
  stage.parameters.tracker = TrackerKind::Tld;
  QVERIFY(!stage.frame().running());
}

void TestToolTracking::manualFollowsNothing() {
  Stage stage;
  stage.parameters.tracker = TrackerKind::Manual;
  stage.tracking.order(TrackBox{box});
  QVERIFY(stage.frame().pixel == std::optional(cv::Point(50, 72)));
  stage.tracking.order(TrackModel{std::make_shared<ToolModel>()});
  const ToolTrack tool = stage.frame();
  QVERIFY(!tool.fault.empty() && !tool.running());
  QVERIFY(tool.pixel);
}

void TestToolTracking::againBeginsWithTheLastBox() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.frames(2);
  stage.tracking.order(TrackAgain{});
  stage.frame();
  QCOMPARE(stage.script->boxes.size(), std::size_t(2));
  QVERIFY(stage.script->boxes.back() == box);
}

void TestToolTracking::againWithoutAnythingSeen() {
  Stage stage;
  stage.tracking.order(TrackAgain{});
  QVERIFY(!stage.frame().fault.empty());
}

void TestToolTracking::forgettingStopsIt() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.frames(2);
  stage.tracking.order(ForgetTool{});
  const ToolTrack tool = stage.frame();
  QVERIFY(!tool.running() && !tool.point && !tool.pixel && !tool.model);
}

void TestToolTracking::learningIsPassedOn() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.frame();
  QVERIFY(stage.script->learning);
  stage.parameters.learn = false;
  stage.frame();
  QVERIFY(!stage.script->learning);
}

void TestToolTracking::anExceptionOfATrackerIsALostTool() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.script->see = [](const cv::Mat&) -> Track { throw std::runtime_error("it broke"); };
  const ToolTrack tool = stage.frame();
  QCOMPARE(text(tool.state), text(TrackState::Lost));
  QVERIFY(tool.fault.find("it broke") != std::string::npos);
}

void TestToolTracking::blackEmptyAndOtherSizedImages() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.frames(2);
  stage.script->see = [](const cv::Mat& image) {
    return cv::countNonZero(greyOf(image)) > 0
               ? Track{TrackState::Tracked, box, 1.0, LearningState::On}
               : Track::lost();
  };
  stage.image = cv::Mat();
  QCOMPARE(text(stage.frame().state), text(TrackState::Lost));
  stage.image = cv::Mat::zeros(160, 160, CV_8UC1);
  QCOMPARE(text(stage.frame().state), text(TrackState::Lost));
  // Smaller than the box reaches: the pixel lies outside the cloud, and there is no point.
  stage.image = texture({40, 40});
  auto small = std::make_shared<Cloud>(*wallCloud(3.0F));
  small->width = small->height = 40;
  small->points.resize(1600);
  stage.cloud = small;
  stage.frames(7);
  QVERIFY(stage.frame().lost());
}

void TestToolTracking::noDepthUnderTheTool() {
  Stage stage;
  stage.tracking.order(TrackBox{box});
  stage.frames(3);
  auto blind = std::make_shared<Cloud>(*stage.cloud);
  for (auto& point : blind->points) point = unmeasuredPoint();
  stage.cloud = blind;
  const ToolTrack within = stage.frames(3);
  QVERIFY(within.box && within.point && !within.lost());
  const ToolTrack beyond = stage.frames(4);
  QVERIFY(beyond.box && !beyond.point && beyond.lost());
}

void TestToolTracking::theBoxEndsTheSearchToTheRight() {
  Stage stage;
  auto holed = std::make_shared<Cloud>(*stage.cloud);
  for (int column = 50; column < 55; ++column)
    holed->points[72U * 160 + column] = unmeasuredPoint();
  stage.cloud = holed;
  stage.tracking.order(TrackBox{box});
  QCOMPARE(*stage.frame().point, holed->at(55, 72));
  for (int column = 55; column < 60; ++column)
    holed->points[72U * 160 + column] = unmeasuredPoint();
  stage.tracking.order(TrackBox{box});
  QVERIFY(stage.frame().lost());
}

void TestToolTracking::nearLooksPastTheGapBetweenTines() {
  Stage stage;
  auto tines = std::make_shared<Cloud>(*stage.cloud);
  for (int row = 60; row < 84; ++row) {
    for (int column = 40; column < 60; ++column) {
      if (column < 48 || column > 52) tines->points[row * 160U + column].z() = 2.0F;
    }
  }
  stage.cloud = tines;
  stage.tracking.order(TrackBox{box});
  QCOMPARE(stage.frame().point->z(), 3.0F);
  stage.parameters.toolPoint = ToolPointRule::Near;
  stage.tracking.order(TrackBox{box});
  QCOMPARE(stage.frame().point->z(), 2.0F);
}

BOOMWATCH_TEST(TestToolTracking)
#include "test_tool_tracking.moc"
