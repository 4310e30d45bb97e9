#include <Eigen/Geometry>
#include <QtTest>

#include "lab/experiments/true_tool.h"
#include "load/held_tool.h"
#include "pipeline/pipeline.h"
#include "support/test_registry.h"
#include "support/yard_frames.h"

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

/// The whole chain on demo:yard, ten frames a second, with a tracker that says what it is told to.
struct Chain {
  YardFrames& frames;
  TrueTool tool;
  Pipeline pipeline{tool.maker()};
  Parameters parameters;
  std::size_t index = 0;
  YardFrame shown;  ///< the last one

  explicit Chain(YardFrames& yard) : frames(yard) {
    pipeline.order(TrueTool::order());
    parameters.load.source = LoadSource::Detected;
  }
  /// `tracked`: what the tracker makes of the tool's true box.
  template <class Tracked>
  Result next(Tracked&& tracked) {
    constexpr std::size_t step = 2;
    shown = frames.withTruth("as=depth,seed=2", step * index++);
    tool.set(tracked(toolBoxIn(shown, 0.25).value()));
    return pipeline.process(shown.frame, parameters);
  }
  void trackRightly() {
    for (int k = 0; k < 12; ++k) next([](const cv::Rect2d& box) { return std::optional(box); });
  }
};

std::optional<cv::Rect2d> slipped(cv::Rect2d box) {
  box.y -= 0.7 * box.height;
  return box;
}

/// Tool and load where they are, and a distance.
bool isRight(const Result& result, const Chain& chain) {
  const YardTruth& yard = *chain.shown.truth;
  return result.clearance.nearest && result.load && result.tool.point &&
         (result.load->centre - yard.load.centre).norm() < 0.15 &&
         (result.tool.point->cast<double>() - yard.toolPoint).norm() < 0.6;
}

}  // namespace

/// The tool's place by the load that it holds.
class TestHeldTool : public QObject {
  Q_OBJECT

  YardFrames m_frames{42};  ///< those that every chain begins with

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
    QVERIFY(held.point(log, 1.0 + HeldTool::maxHold));
    QVERIFY(!held.point(log, 1.1 + HeldTool::maxHold));
    QVERIFY(!held.point(log, 0.9));  // the source began anew
  }

  /// A load that is seen keeps its distance though the tracker has lost the tool: until it has been
  /// lost for too long.
  void aLoadThatIsSeenKeepsItsDistance() {
    Chain chain(m_frames);
    chain.trackRightly();
    double lostFor = 0.0;
    for (int k = 0; k < 50; ++k) {
      const Result result = chain.next([](const cv::Rect2d&) { return std::nullopt; });
      lostFor = *result.tool.age;
      const bool mayHold = lostFor < HeldTool::maxHold;
      QCOMPARE(result.tool.isHeld, mayHold);
      QCOMPARE(result.tool.lost(), !mayHold);
      QCOMPARE(result.clearance.reason == Reason::ToolLost, !mayHold);
      if (mayHold) QVERIFY(isRight(result, chain));
    }
    QVERIFY(lostFor > HeldTool::maxHold);
  }

  /// A tracker that slips from the tool to the boom above it, which is near enough for the tool,
  /// does not take the load along.
  void aTrackerThatSlipsDoesNotTakeTheLoadAlong() {
    Chain chain(m_frames);
    chain.trackRightly();
    for (int k = 0; k < 30; ++k) {
      QVERIFY2(isRight(chain.next(slipped), chain), qPrintable(QString::number(k)));
    }
  }

  void anOrderIsObeyedWhateverIsHeld() {
    Chain chain(m_frames);
    chain.trackRightly();
    chain.pipeline.order(TrueTool::order());
    const ToolTrack tool = chain.next(slipped).tool;
    QVERIFY(tool.point && tool.age == 0.0);
    QVERIFY(!tool.isHeld && !tool.isDoubted);
  }
};

BOOMWATCH_TEST(TestHeldTool)
#include "test_held_tool.moc"
