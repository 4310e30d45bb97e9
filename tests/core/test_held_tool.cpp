#include <Eigen/Geometry>
#include <QtTest>

#include "experiments/true_tool.h"
#include "load/held_tool.h"
#include "pipeline/pipeline.h"
#include "yard_frames.h"

using namespace boomwatch;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

OrientedBox logAt(const Vector3d& centre, double turn) {
  OrientedBox log;
  log.centre = centre;
  log.size = {2.5, 0.3, 0.3};
  log.rotation = Eigen::AngleAxisd(turn, Vector3d::UnitY()).toRotationMatrix();
  return log;
}

/// Held 0.3 m beside the log's middle, 0.7 m above it; y points down.
Vector3f toolOf(const OrientedBox& log) {
  return (log.centre + 0.3 * log.rotation.col(0) - 0.7 * Vector3d::UnitY()).cast<float>();
}

}  // namespace

/// The tool's place by the load that it holds.
class TestHeldTool : public QObject {
  Q_OBJECT
 private slots:
  void nothingIsKnownAtFirst() { QVERIFY(!HeldTool().point(logAt({0, 0, 6}, 0.0), 0.0)); }

  void itGoesAndTurnsWithTheLoad() {
    HeldTool held;
    const OrientedBox log = logAt({0, 0, 6}, 0.0), moved = logAt({1, -0.5, 7}, 0.5);
    held.learn(toolOf(log), log, 1.0);
    const auto tool = held.point(moved, 2.0);
    QVERIFY(tool);
    QVERIFY((*tool - toolOf(moved)).norm() < 1e-5F);
  }

  void onePointThatIsOffIsSmoothed() {
    HeldTool held;
    const OrientedBox log = logAt({0, 0, 6}, 0.0);
    for (int k = 0; k < 20; ++k) held.learn(toolOf(log), log, 0.1 * k);
    held.learn(toolOf(log) + Vector3f(0.5F, 0, 0), log, 2.0);
    QVERIFY((*held.point(log, 2.0) - toolOf(log)).norm() < 0.1F);
  }

  void afterAWhileItMayHaveBeenLaidDown() {
    HeldTool held;
    const OrientedBox log = logAt({0, 0, 6}, 0.0);
    held.learn(toolOf(log), log, 1.0);
    QVERIFY(held.point(log, 1.0 + HeldTool::longestHold));
    QVERIFY(!held.point(log, 1.1 + HeldTool::longestHold));
    QVERIFY(!held.point(log, 0.9));  // the source began anew
  }

  /// A load that is seen keeps its distance though the tracker has lost the tool: until it has been
  /// lost for too long.
  void aLoadThatIsSeenKeepsItsDistance() {
    constexpr std::size_t step = 2;  // 0.1 s
    constexpr int tracked = 12;
    YardFrames frames;
    TrueTool truth;
    Pipeline pipeline(truth.maker());
    pipeline.order(TrueTool::order());
    Parameters parameters;
    parameters.load.source = LoadSource::Detected;
    double lostFor = 0.0;
    for (int k = 0; k < tracked + 50; ++k) {
      const FramePtr frame = frames.at("as=depth,seed=2", static_cast<std::size_t>(k) * step);
      truth.set(k < tracked ? toolBoxIn(*frame, 0.25) : std::nullopt);
      const Result result = pipeline.process(frame, parameters);
      if (k < tracked) continue;
      lostFor = *result.tool.age;
      const bool mayHold = lostFor < HeldTool::longestHold;
      QCOMPARE(result.tool.isHeld, mayHold);
      QCOMPARE(result.tool.lost(), !mayHold);
      QCOMPARE(result.clearance.reason == Reason::ToolLost, !mayHold);
      if (!mayHold) continue;
      const YardTruth& yard = *frame->truth->yard;
      QVERIFY(result.clearance.nearest);
      QVERIFY((result.load->centre - yard.load.centre).norm() < 0.15);
      QVERIFY((result.tool.point->cast<double>() - yard.toolPoint).norm() < 0.6);
    }
    QVERIFY(lostFor > HeldTool::longestHold);
  }

  /// A tracker that slips from the tool to the boom above it, which is near enough for the tool,
  /// does not take the load along.
  void aTrackerThatSlipsDoesNotTakeTheLoadAlong() {
    constexpr std::size_t step = 2;  // 0.1 s
    constexpr int tracked = 12;
    YardFrames frames;
    TrueTool truth;
    Pipeline pipeline(truth.maker());
    pipeline.order(TrueTool::order());
    Parameters parameters;
    parameters.load.source = LoadSource::Detected;
    for (int k = 0; k < tracked + 30; ++k) {
      const FramePtr frame = frames.at("as=depth,seed=2", static_cast<std::size_t>(k) * step);
      auto box = toolBoxIn(*frame, 0.25);
      QVERIFY(box);
      if (k >= tracked) box->y -= 0.7 * box->height;
      truth.set(box);
      const Result result = pipeline.process(frame, parameters);
      if (k < tracked) continue;
      const YardTruth& yard = *frame->truth->yard;
      QVERIFY2(result.clearance.nearest, qPrintable(QString::number(k)));
      QVERIFY((result.load->centre - yard.load.centre).norm() < 0.15);
      QVERIFY((result.tool.point->cast<double>() - yard.toolPoint).norm() < 0.6);
    }
  }
};

QTEST_GUILESS_MAIN(TestHeldTool)
#include "test_held_tool.moc"
