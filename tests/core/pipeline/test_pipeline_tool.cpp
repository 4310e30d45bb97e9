#include <QtTest>
#include <algorithm>

#include "frame/stereo_rig.h"
#include "pipeline/pipeline.h"
#include "support/compare_near.h"
#include "support/fake_tracker.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

/// Names, so that a failed comparison says which.
template <class Enum>
QByteArray text(Enum value) {
  return QByteArray(toString(value).data());
}

const cv::Rect2d box(70, 70, 20, 20);

/// The wall, and a boom 0.3 m wide that hangs 1 m in front of it in the middle of the picture.
FramePtr boomFrame(std::uint64_t sequence) {
  auto frame = std::make_shared<Frame>(*wallFrame(sequence, 3.0F));
  auto cloud = std::make_shared<Cloud>(*frame->cloud);
  for (int row = 74; row < 86; ++row) {
    for (int column = 74; column < 86; ++column) cloud->points[row * 160U + column] *= 2.0F / 3.0F;
  }
  frame->cloud = cloud;
  return frame;
}

/// A pipeline with fake trackers, fed with boomFrame; a load hangs beside the boom.
struct Chain {
  std::shared_ptr<TrackerScript> script = std::make_shared<TrackerScript>();
  Pipeline pipeline{fakeTrackers(script)};
  Parameters parameters = smallParameters();
  std::uint64_t sequence = 0;

  Chain() {
    hangLoad(parameters, 2.0, 0.2);
    parameters.load.x = 0.5;
  }
  Result frames(int count) {
    Result last;
    for (int i = 0; i < count; ++i) last = pipeline.process(boomFrame(sequence++), parameters);
    return last;
  }
};

/// A pair that has to be rectified; the calibration is for pictures of `calibrated`.
FramePtr stereoFrame(std::uint64_t sequence, cv::Size calibrated) {
  auto rig = std::make_shared<StereoRig>();
  rig->imageSize = calibrated;
  rig->leftMatrix = rig->rightMatrix = {200, 0, 160, 0, 200, 100, 0, 0, 1};
  rig->translation = {-0.2, 0, 0};
  auto frame = std::make_shared<Frame>();
  frame->sequence = sequence;
  frame->stamp = static_cast<double>(sequence) * 0.05;
  frame->left = texture({320, 200}, 0);
  frame->right = texture({320, 200}, 10);
  frame->rig = rig;
  return frame;
}

bool boomIsInModel(const Pipeline& pipeline) {
  const auto levels = pipeline.model().levels();
  // At 2 m of 5 m; the wall is at level 153.
  return std::ranges::any_of(levels, [](int level) { return level > 0 && level < 130; });
}

Track lostTrack(const cv::Mat&) { return Track::lost(); }

}  // namespace

class TestPipelineTool : public QObject {
  Q_OBJECT
 private slots:
  void autoDetectsWhereAToolIsFollowedAndElseAsksTheScene();
  void withoutTheToolThatTheSceneHasThereIsNoDistance();
  void whatWasLearntOfTheCraneBeforeTheToolWasKnownIsForgotten();
  void withoutAToolEverythingIsAsItWas();
  void theToolIsTakenOutWhereItIsTracked();
  void withinTheLimitItIsTakenOutWhereItMustBe();
  void beyondTheLimitThereIsNoDistance();
  void aLostToolTeachesNothing();
  void aTrackerThatHasGoneAstrayTeachesNothing_data();
  void aTrackerThatHasGoneAstrayTeachesNothing();
  void aBoxThatDoesNotFitIsNoDistance();
  void aFaultOfTheFrameGoesFirst();
  void resetForgetsTheTool();
  void theTrackerSeesThePictureThatTheCloudBelongsTo();
  void anOrderWaitsForAFrameThatCanBeUsed();
};

void TestPipelineTool::withoutAToolEverythingIsAsItWas() {
  Chain chain;
  const Result result = chain.frames(6);
  QVERIFY(!result.tool.running());
  QVERIFY(result.clearance.nearest);
  QVERIFY(boomIsInModel(chain.pipeline));
}

void TestPipelineTool::theToolIsTakenOutWhereItIsTracked() {
  Chain chain;
  chain.pipeline.order(TrackBox{box});
  const Result result = chain.frames(6);
  QCOMPARE(result.scene.toolMask, ToolMask::Taken);
  QVERIFY(result.clearance.nearest);
  QVERIFY(!boomIsInModel(chain.pipeline));
  // The wall is what is nearest now: 0.9 m behind the load.
  BW_COMPARE_NEAR(result.clearance.nearest->distance, 0.9, 0.05);
}

void TestPipelineTool::withinTheLimitItIsTakenOutWhereItMustBe() {
  Chain chain;
  chain.pipeline.order(TrackBox{box});
  chain.frames(6);
  chain.script->see = lostTrack;
  const Result result = chain.frames(8);  // 0.4 s
  QCOMPARE(result.scene.toolMask, ToolMask::Taken);
  QVERIFY(result.clearance.nearest);
  QVERIFY(*result.tool.age > 0.3);
}

void TestPipelineTool::beyondTheLimitThereIsNoDistance() {
  Chain chain;
  chain.pipeline.order(TrackBox{box});
  chain.frames(6);
  chain.script->see = lostTrack;
  const Result result = chain.frames(11);  // 0.55 s
  QCOMPARE(text(result.clearance.reason), text(Reason::ToolLost));
  QVERIFY(!result.clearance.nearest);
  QCOMPARE(text(result.level), text(WarningLevel::NoDistance));
  QCOMPARE(result.scene.toolMask, ToolMask::NoToolPoint);
  QVERIFY(!result.scene.toolBox);
  chain.script->see = nullptr;
  QVERIFY(chain.frames(1).clearance.nearest);
}

void TestPipelineTool::aLostToolTeachesNothing() {
  Chain chain;
  chain.pipeline.order(TrackBox{box});
  chain.frames(6);
  chain.script->see = lostTrack;
  chain.frames(40);
  QVERIFY(!boomIsInModel(chain.pipeline));
}

void TestPipelineTool::aTrackerThatHasGoneAstrayTeachesNothing_data() {
  QTest::addColumn<float>("depth");
  QTest::addColumn<ToolMask>("mask");
  QTest::newRow("on the wall") << 3.0F << ToolMask::TooLarge;
  QTest::newRow("beyond the bounds") << 20.0F << ToolMask::NothingThere;
}

/// The box stays on something else, and the tracker is sure of it.
void TestPipelineTool::aTrackerThatHasGoneAstrayTeachesNothing() {
  QFETCH(float, depth);
  QFETCH(ToolMask, mask);
  Chain chain;
  chain.parameters.load.source = LoadSource::Detected;
  chain.pipeline.order(TrackBox{box});
  chain.frames(6);
  QVERIFY(chain.pipeline.model().frames() > 0);
  chain.script->see = [](const cv::Mat&) {
    return Track{TrackState::Tracked, cv::Rect2d(35, 70, 20, 20), 0.9, LearningState::None};
  };
  Result last;
  for (int n = 0; n < 40; ++n) {
    auto frame = std::make_shared<Frame>(*boomFrame(chain.sequence++));
    auto cloud = std::make_shared<Cloud>(*frame->cloud);
    for (int row = 65; row < 95; ++row) {
      for (int column = 30; column < 60; ++column) {
        cloud->points[row * 160U + column] *= depth / 3.0F;
      }
    }
    frame->cloud = cloud;
    last = chain.pipeline.process(frame, chain.parameters);
  }
  QCOMPARE(last.scene.toolMask, mask);
  QVERIFY(!boomIsInModel(chain.pipeline));
}

void TestPipelineTool::aBoxThatDoesNotFitIsNoDistance() {
  Chain chain;
  chain.pipeline.order(TrackBox{{150, 150, 40, 40}});
  const Result first = chain.frames(1);
  QVERIFY(!first.tool.fault.empty());
  QCOMPARE(text(chain.frames(6).clearance.reason), text(Reason::ToolLost));
  chain.pipeline.order(ForgetTool{});
  QVERIFY(chain.frames(6).clearance.nearest);
}

void TestPipelineTool::aFaultOfTheFrameGoesFirst() {
  Chain chain;
  chain.script->see = lostTrack;
  chain.pipeline.order(TrackBox{box});
  auto blind = std::make_shared<Frame>(*boomFrame(0));
  auto cloud = std::make_shared<Cloud>(*blind->cloud);
  for (auto& point : cloud->points) point = unmeasuredPoint();
  blind->cloud = cloud;
  QCOMPARE(text(chain.pipeline.process(blind, chain.parameters).clearance.reason),
           text(Reason::FewDepthPixels));
}

void TestPipelineTool::resetForgetsTheTool() {
  Chain chain;
  chain.pipeline.order(TrackBox{box});
  QVERIFY(chain.frames(2).tool.running());
  chain.pipeline.reset();
  QVERIFY(!chain.frames(1).tool.running());
}

void TestPipelineTool::theTrackerSeesThePictureThatTheCloudBelongsTo() {
  Chain chain;
  cv::Mat seen;
  chain.script->see = [&](const cv::Mat& image) {
    seen = image;
    return Track{TrackState::Tracked, box, 1.0, LearningState::None};
  };
  chain.pipeline.order(TrackBox{box});
  const Result result = chain.pipeline.process(stereoFrame(0, {320, 200}), chain.parameters);
  QVERIFY(!seen.empty());
  QCOMPARE(seen.data, result.image.data);
  // Rectified: not the picture as it came.
  QVERIFY(seen.data != result.frame->left.data);
}

void TestPipelineTool::anOrderWaitsForAFrameThatCanBeUsed() {
  Chain chain;
  chain.pipeline.order(TrackBox{box});
  // The calibration is for pictures of another size.
  const Result unusable = chain.pipeline.process(stereoFrame(0, {640, 480}), chain.parameters);
  QCOMPARE(text(unusable.clearance.reason), text(Reason::UnreadableFrame));
  QVERIFY(chain.script->boxes.empty());
  chain.pipeline.process(stereoFrame(1, {320, 200}), chain.parameters);
  QCOMPARE(chain.script->boxes.size(), std::size_t(1));
}

/// The scene knows a load beside the boom; nothing hangs at the boom.
void TestPipelineTool::autoDetectsWhereAToolIsFollowedAndElseAsksTheScene() {
  const auto run = [](bool offersTool) {
    Chain chain;
    chain.parameters.load.source = LoadSource::Auto;
    Result last;
    for (int n = 0; n < 6; ++n) {
      auto frame = std::make_shared<Frame>(*boomFrame(chain.sequence++));
      frame->load = OrientedBox{{0.5, 0, 2.0}, {0.2, 0.2, 0.2}};
      if (offersTool) frame->tool = box;
      last = chain.pipeline.process(frame, chain.parameters);
    }
    return last;
  };
  const Result scene = run(false);
  QVERIFY(scene.load && !scene.loadAge);
  QCOMPARE(text(scene.clearance.state), text(ClearanceState::Measured));
  const Result detected = run(true);
  QVERIFY(detected.tool.running());
  QVERIFY(!detected.load);
  QCOMPARE(text(detected.clearance.reason), text(Reason::LoadNotSeen));
}

/// The scene's load would touch the boom, which nobody can take out.
void TestPipelineTool::withoutTheToolThatTheSceneHasThereIsNoDistance() {
  Chain chain;
  chain.parameters.load.source = LoadSource::Auto;
  const auto next = [&] {
    auto frame = std::make_shared<Frame>(*boomFrame(chain.sequence++));
    frame->load = OrientedBox{{0, 0, 2.0}, {0.2, 0.2, 0.2}};
    frame->tool = box;
    return chain.pipeline.process(frame, chain.parameters);
  };
  QVERIFY(next().tool.running());
  chain.pipeline.order(ForgetTool{});
  for (int n = 0; n < 6; ++n) {
    const Result result = next();
    QVERIFY(!result.tool.running() && !result.load);
    QCOMPARE(text(result.clearance.reason), text(Reason::NoTool));
  }
}

/// A load that touches the boom: from the first frame in which the tool is known on, nothing is
/// said that only the boom in the model would be the reason of.
void TestPipelineTool::whatWasLearntOfTheCraneBeforeTheToolWasKnownIsForgotten() {
  Chain chain;
  chain.parameters.load.x = 0.2;
  QVERIFY(chain.frames(10).clearance.nearest->distance < 0.1);
  chain.pipeline.order(TrackBox{box});
  for (int n = 0; n < 10; ++n) {
    const Result result = chain.frames(1);
    QCOMPARE(result.scene.toolMask, ToolMask::Taken);
    QVERIFY(!boomIsInModel(chain.pipeline));
    QVERIFY(!result.clearance.nearest || result.clearance.nearest->distance > 0.8);
  }
  // Once only: what is learnt with the tool stays.
  QVERIFY(chain.frames(1).clearance.nearest);
}

BOOMWATCH_TEST(TestPipelineTool)
#include "test_pipeline_tool.moc"
