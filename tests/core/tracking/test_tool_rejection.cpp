#include <QtTest>

#include "support/test_registry.h"
#include "support/tool_stage.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

const cv::Rect2d box(40, 60, 20, 24), elsewhere(100, 100, 20, 20);

/// Its tracker has long been right.
struct Stage : ToolStage {
  Stage() {
    tracking.order(TrackBox{box});
    frames(20);
  }

  /// The tracker goes on, sure of itself, on a wall 17 m further away.
  void leap() {
    cloud = wallCloud(20.0F);
    script->see = [](const cv::Mat&) {
      return Track{TrackState::Tracked, elsewhere, 0.9, LearningState::On};
    };
  }
};

}  // namespace

/// What becomes of a tracker that follows something else than the tool.
class TestToolRejection : public QObject {
  Q_OBJECT
 private slots:
  void aTrackerThatLeapsIsToldSo();
  void aWrongDepthForAMomentHarmsNobody();
  void againBeginsWhereTheToolSurelyWas();
  void whatIsInsistedOnForLongIsTheTool();
};

void TestToolRejection::aTrackerThatLeapsIsToldSo() {
  Stage stage;
  QCOMPARE(stage.script->rejections, 0);
  stage.leap();
  const ToolTrack soon = stage.frames(4);
  QVERIFY(soon.point && soon.point->z() < 4.0F);
  QVERIFY(soon.box && soon.isDoubted);
  const ToolTrack late = stage.frames(4);
  QVERIFY(stage.script->rejections > 0);
  QVERIFY(late.lost());
  QVERIFY(late.state == TrackState::Lost);
  QVERIFY(!late.box && !late.pixel && !late.isDoubted && late.confidence == 0.0);
  // It learns all the same, once it has found the tool again.
  QVERIFY(late.learning == LearningState::On);
}

/// Through a grapple the ground is seen, or a leaf comes before it: the box is right all the time.
void TestToolRejection::aWrongDepthForAMomentHarmsNobody() {
  Stage stage;
  const auto right = stage.cloud;
  stage.cloud = wallCloud(20.0F);
  const ToolTrack during = stage.frames(4);
  QVERIFY(during.box && during.point && during.point->z() < 4.0F);
  stage.cloud = right;
  const ToolTrack after = stage.frames(1);
  QCOMPARE(stage.script->rejections, 0);
  QCOMPARE(*after.age, 0.0);
  QVERIFY(!after.isDoubted);
}

void TestToolRejection::againBeginsWhereTheToolSurelyWas() {
  Stage stage;
  stage.leap();
  stage.frames(8);
  stage.tracking.order(TrackAgain{});
  stage.frames(1);
  QVERIFY(stage.script->boxes.size() == 2 && stage.script->boxes.back() == box);
}

void TestToolRejection::whatIsInsistedOnForLongIsTheTool() {
  Stage stage;
  stage.leap();
  QVERIFY(stage.frames(29).lost());
  QVERIFY(stage.frames(4).point);
}

BOOMWATCH_TEST(TestToolRejection)
#include "test_tool_rejection.moc"
