#include <QtTest>

#include "pipeline/frame_checks.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

FrameChecks::Verdict examined(FrameChecks& checks, const FramePtr& frame,
                              const ValidityParameters& parameters = {}) {
  return checks.examine(frame, frame->left, *frame->cloud, parameters);
}

FramePtr still(const FramePtr& frame) {
  auto copy = std::make_shared<Frame>(*frame);
  copy->still = true;
  return copy;
}

}  // namespace

class TestFrameChecks : public QObject {
  Q_OBJECT
 private slots:
  void fillIsTheShareOfPointsThatWereMeasured() {
    auto cloud = wallCloud(3.0F);
    for (std::size_t k = 0; k < cloud->size(); ++k) {
      if (k % 4 != 0) cloud->points[k] = unmeasuredPoint();
    }
    auto frame = std::make_shared<Frame>(*wallFrame(0, 3.0F));
    frame->cloud = cloud;
    FrameChecks checks;
    ValidityParameters parameters;
    parameters.minFill = 0.25;
    const auto enough = examined(checks, frame, parameters);
    QCOMPARE(enough.fill, 0.25);
    QVERIFY(enough.reason == Reason::None);
    parameters.minFill = 0.26;
    checks.reset();
    QVERIFY(examined(checks, frame, parameters).reason == Reason::FewDepthPixels);
    QCOMPARE(checks.examine(frame, {}, Cloud(), parameters).fill, 0.0);
  }

  void equalFramesInARowAreAFrozenSource() {
    FrameChecks checks;
    const FramePtr frame = wallFrame(0, 3.0F);
    QVERIFY(examined(checks, frame).reason == Reason::None);
    QVERIFY(examined(checks, frame).reason == Reason::None);
    QVERIFY(examined(checks, frame).reason == Reason::IdenticalFrames);
    // One grey level of one pixel is another picture.
    QVERIFY(examined(checks, wallFrame(1, 3.0F)).reason == Reason::None);
  }

  void whatIsStillOnPurposeIsNotFrozen() {
    FrameChecks checks;
    const FramePtr frame = still(wallFrame(0, 3.0F));
    for (int k = 0; k < 10; ++k) QVERIFY(examined(checks, frame).reason == Reason::None);
  }

  void framesFromAnotherTimeMakeTheModelStale() {
    const auto isStaleAfter = [](std::uint64_t first, std::uint64_t second) {
      FrameChecks checks;
      checks.examine(wallFrame(first, 3.0F), {}, *wallCloud(3.0F), {});
      return checks.examine(wallFrame(second, 3.0F), {}, *wallCloud(3.0F), {}).modelIsStale;
    };
    QVERIFY(!isStaleAfter(20, 21));
    QVERIFY(!isStaleAfter(20, 31));  // ten frames lost
    QVERIFY(isStaleAfter(20, 32));
    QVERIFY(isStaleAfter(20, 19));
  }

  void aCameraThatMovesForThreeFramesMakesTheModelStale() {
    FrameChecks checks;
    QVERIFY(examined(checks, wallFrame(0, 3.0F, 0)).reason == Reason::None);
    for (int k = 1; k <= 3; ++k) {
      const auto verdict = examined(checks, wallFrame(static_cast<std::uint64_t>(k), 3.0F, 2 * k));
      QVERIFY(verdict.reason == Reason::SceneMoves);
      QCOMPARE(verdict.modelIsStale, k == 3);
    }
    const auto rest = examined(checks, wallFrame(4, 3.0F, 6));
    QVERIFY(rest.reason == Reason::None && !rest.modelIsStale);
  }

  void atOneTheMotionIsNotLookedAt() {
    FrameChecks checks;
    ValidityParameters parameters;
    parameters.sceneMotion = 1.0;
    for (int k = 0; k < 4; ++k) {
      const FramePtr frame = wallFrame(static_cast<std::uint64_t>(k), 3.0F, 2 * k);
      QVERIFY(examined(checks, frame, parameters).reason == Reason::None);
    }
  }
};

BOOMWATCH_TEST(TestFrameChecks)
#include "test_frame_checks.moc"
