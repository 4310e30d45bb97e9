#include <QtTest>

#include "base/error.h"
#include "crane/crane_boxes.h"
#include "pipeline/parameter_checks.h"
#include "pipeline/pipeline.h"
#include "support/collision_scenes.h"
#include "support/compare_near.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

void addBar(Points& points, const Vector3d& from, const Vector3d& to) {
  for (double t = 0.0; t <= 1.0; t += 0.01) {
    for (const double side : {-0.1, -0.05, 0.0, 0.05, 0.1}) {
      points.push_back((from + t * (to - from) + Vector3d(0, 0, side)).cast<float>());
    }
  }
}

Watched measured(WatchedObject object, double distance) {
  Watched watched;
  watched.object = object;
  watched.clearance.state = ClearanceState::Measured;
  watched.clearance.reason = Reason::None;
  watched.clearance.nearest = Nearest{};
  watched.clearance.nearest->distance = distance;
  return watched;
}

Watched unknown(WatchedObject object, Reason reason) {
  return {object, 0, {}, Clearance::unknown(reason)};
}

/// The wall of flat_scene, and before it a rod that hangs from the upper edge down to (0, 0, z).
FramePtr rodBeforeWall(std::uint64_t sequence, float wall, float z) {
  const FramePtr plain = wallFrame(sequence, wall);
  auto frame = std::make_shared<Frame>(*plain);
  auto cloud = std::make_shared<Cloud>(*plain->cloud);
  for (int row = 0; row < 80; ++row) {
    for (int column = 76; column < 84; ++column) {
      cloud->points[static_cast<std::size_t>(row * 160 + column)] =
          Vector3f(static_cast<float>(column) - 79.5F, static_cast<float>(row) - 79.5F, 80.0F) *
          (z / 80.0F);
    }
  }
  frame->cloud = cloud;
  return frame;
}

}  // namespace

class TestWatched : public QObject {
  Q_OBJECT
 private slots:
  void cutsTheBoomWhereItBends();
  void leavesTheLoadOut();
  void theSmallestDistanceLeads();
  void anUnknownLoadIsNotHiddenByACalmTool();
  void measuresToolAndBoomBesideTheLoad();
  void sizesBelowTheSmallestThingDoNotCount();
  void nothingWatchedIsRefused();
  void aBoomThatIsNotToldFromTheWallTeachesNothingAtFirst();
  void aLeafBeforeTheToolTeachesNothingAtFirst();
};

void TestWatched::cutsTheBoomWhereItBends() {
  Points points;
  addBar(points, {0, -2, 5}, {0, 0, 5});     // hangs at the tool
  addBar(points, {0, -2, 5}, {3, -2.5, 5});  // the main boom
  const CraneBoxes boxes = craneBoxes(points, {0, 0, 5}, 0.8, std::nullopt);
  QVERIFY(boxes.tool);
  QVERIFY(boxes.tool->contains({0, -0.2, 5}));
  QCOMPARE(boxes.boom.size(), std::size_t{2});
  // The first is the one at the tool; each is long and thin, along its bar.
  for (const OrientedBox& box : boxes.boom) {
    QVERIFY(box.size.x() > 1.0);
    QVERIFY2(box.size.y() < 0.5 && box.size.z() < 0.5, qPrintable(QString::number(box.size.y())));
    BW_COMPARE_NEAR(box.rotation.determinant(), 1.0, 1e-9);
  }
  QVERIFY(std::abs(boxes.boom[0].rotation.col(0).y()) > 0.95);
  QVERIFY(std::abs(boxes.boom[1].rotation.col(0).x()) > 0.95);
}

void TestWatched::leavesTheLoadOut() {
  Points points;
  addBar(points, {0, -1, 5}, {0, 0, 5});
  addBar(points, {-1, 0.2, 5}, {1, 0.2, 5});
  const OrientedBox load{{0, 0.2, 5}, {2.1, 0.1, 0.4}};
  const CraneBoxes boxes = craneBoxes(points, {0, 0, 5}, 0.8, load);
  QCOMPARE(boxes.boom.size(), std::size_t{1});
  QVERIFY(boxes.tool->size.x() < 0.1);
  QVERIFY(craneBoxes({}, {0, 0, 5}, 0.8, load).boom.empty());
}

void TestWatched::theSmallestDistanceLeads() {
  const WarningParameters limits;
  QCOMPARE(
      leadingOf({measured(WatchedObject::Load, 2.0), measured(WatchedObject::Tool, 1.5)}, limits),
      std::size_t{1});
  QCOMPARE(
      leadingOf({measured(WatchedObject::Load, 1.0), measured(WatchedObject::Tool, 1.5)}, limits),
      std::size_t{0});
  Watched clear = unknown(WatchedObject::Load, Reason::None);
  clear.clearance.state = ClearanceState::NothingInRange;
  QCOMPARE(leadingOf({clear, unknown(WatchedObject::Tool, Reason::ToolNotSeen)}, limits),
           std::size_t{0});
  QCOMPARE(leadingOf({clear, measured(WatchedObject::Tool, 8.0)}, limits), std::size_t{1});
}

void TestWatched::anUnknownLoadIsNotHiddenByACalmTool() {
  WarningParameters limits;
  limits.warningDistance = 1.0;
  const Watched load = unknown(WatchedObject::Load, Reason::LoadNotSeen);
  QCOMPARE(leadingOf({load, measured(WatchedObject::Tool, 1.5)}, limits), std::size_t{0});
  QCOMPARE(leadingOf({load, measured(WatchedObject::Tool, 0.9)}, limits), std::size_t{1});
}

void TestWatched::measuresToolAndBoomBesideTheLoad() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 2.0, 0.2);
  parameters.load.y = 1.0;
  parameters.load.toolSize = 0.6;
  parameters.watch.tool = parameters.watch.boom = true;
  Pipeline pipeline;
  pipeline.order(PickTool{{80, 78}});
  Result result;
  for (std::uint64_t n = 0; n < 6; ++n) {
    result = pipeline.process(rodBeforeWall(n, 3.0F, 2.5F), parameters);
  }
  QVERIFY(result.scene.toolMask == ToolMask::Taken);
  QCOMPARE(result.watched.size(), std::size_t{3});
  QVERIFY(result.watched[0].object == WatchedObject::Load);
  QVERIFY(result.watched[1].object == WatchedObject::Tool);
  QVERIFY(result.watched[2].object == WatchedObject::Boom);
  for (const Watched& watched : result.watched) {
    const double z = watched.object == WatchedObject::Load ? 2.1 : 2.5;
    const Nearest& nearest = *watched.clearance.nearest;
    BW_COMPARE_NEAR(nearest.distance, 3.0 - z, nearest.quantisation + 0.01);
  }
  QVERIFY(result.leading != 0);
  QCOMPARE(result.clearance.nearest->distance,
           result.watched[result.leading].clearance.nearest->distance);
}

void TestWatched::sizesBelowTheSmallestThingDoNotCount() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.0, 0.2);
  // A speck of two by two pixels, 6 cm at 2 m, before the wall at 3 m.
  const auto run = [&](double smallest) {
    parameters.clearance.smallestThing = smallest;
    Pipeline pipeline;
    Result result;
    for (std::uint64_t n = 0; n < 7; ++n) {
      auto frame = std::make_shared<Frame>(*wallFrame(n, 3.0F));
      auto cloud = std::make_shared<Cloud>(*frame->cloud);
      for (const int k : {79 * 160 + 79, 79 * 160 + 80}) {
        cloud->points[static_cast<std::size_t>(k)] *= 2.0F / 3.0F;
      }
      frame->cloud = cloud;
      result = pipeline.process(frame, parameters);
    }
    return result;
  };
  const Result all = run(0.0);
  BW_COMPARE_NEAR(all.clearance.nearest->distance, 0.9, 0.05);
  QVERIFY(all.suppressed.empty());
  QVERIFY(all.clearance.evidence->confidence < 0.2);
  const Result large = run(0.2);
  BW_COMPARE_NEAR(large.clearance.nearest->distance, 1.9, 0.05);
  QVERIFY(!large.suppressed.empty());
  QVERIFY(large.clearance.evidence->confidence > 0.8);
}

void TestWatched::nothingWatchedIsRefused() {
  Parameters parameters = smallParameters();
  parameters.watch.load = false;
  QVERIFY_EXCEPTION_THROWN(validate(parameters), Error);
  parameters.watch.tool = true;
  validate(parameters);
}

void TestWatched::aBoomThatIsNotToldFromTheWallTeachesNothingAtFirst() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5, 0.2);
  Pipeline pipeline;
  pipeline.order(PickTool{{80, 78}});
  std::uint64_t frame = 0;
  const auto run = [&](int frames) {
    Result result;
    for (int n = 0; n < frames; ++n) {
      result = pipeline.process(rodBeforeWall(frame++, 3.0F, 2.5F), parameters);
    }
    return result;
  };
  const double before = run(8).clearance.nearest->distance;
  BW_COMPARE_NEAR(before, 1.4, 0.05);        // to the wall
  parameters.filter.clusterTolerance = 1.0;  // rod and wall are one
  const Result touching = run(9);            // 0.45 s
  QVERIFY(touching.scene.toolMask == ToolMask::TooLarge);
  QCOMPARE(touching.clearance.nearest->distance, before);
  // For longer: then it is better to warn of the rod than not to learn what comes.
  BW_COMPARE_NEAR(run(20).clearance.nearest->distance, 0.9, 0.05);
}

// A leaf close to the camera is taken for the tool's point: for a moment the rod is not masked.
void TestWatched::aLeafBeforeTheToolTeachesNothingAtFirst() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5, 0.2);
  parameters.filter.clusterMinimum = 5;
  Pipeline pipeline;
  pipeline.order(PickTool{{80, 78}});
  std::uint64_t index = 0;
  const auto run = [&](int frames, bool leaf) {
    Result result;
    for (int n = 0; n < frames; ++n) {
      auto frame = std::make_shared<Frame>(*rodBeforeWall(index++, 3.0F, 2.5F));
      auto cloud = std::make_shared<Cloud>(*frame->cloud);
      // Too small to be a cluster.
      if (leaf) cloud->points[78 * 160 + 80] *= 0.4F;
      frame->cloud = cloud;
      result = pipeline.process(frame, parameters);
    }
    return result;
  };
  const double before = run(8, false).clearance.nearest->distance;
  BW_COMPARE_NEAR(before, 1.4, 0.05);  // to the wall
  const Result hidden = run(9, true);  // 0.45 s
  QVERIFY(hidden.scene.toolMask == ToolMask::NothingThere);
  QCOMPARE(hidden.clearance.nearest->distance, before);
  BW_COMPARE_NEAR(run(20, true).clearance.nearest->distance, 0.9, 0.05);
}

BOOMWATCH_TEST(TestWatched)
#include "test_watched.moc"
