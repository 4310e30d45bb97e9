#include <QtTest>

#include "lab/experiments/true_tool.h"
#include "pipeline/pipeline.h"
#include "simulation/yard/yard_source.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;

/// A load that is carried and not found, as one that points at the camera: here because the
/// operator has locked a length that it does not have.
class TestUnseenLoad : public QObject {
  Q_OBJECT
 private slots:
  void itTeachesNothing_data() {
    QTest::addColumn<int>("seed");
    for (const int seed : {2, 3, 6}) QTest::addRow("yard %d", seed) << seed;
  }
  void itTeachesNothing() {
    QFETCH(const int, seed);
    constexpr int unseen = 12, seen = 6;
    const YardSource source("as=depth,path=random,seed=" + std::to_string(seed) + ",frames=100");
    TrueTool tool;
    Pipeline pipeline(tool.maker());
    pipeline.order(TrueTool::order());
    Parameters parameters;
    parameters.load.source = LoadSource::Detected;
    const int learning = *framesToEnter(parameters.model);
    bool withheld = false;
    for (int k = 0; k < unseen + seen; ++k) {
      const YardFrame shown = source.at(static_cast<std::size_t>(k));
      const FramePtr& frame = shown.frame;
      tool.set(toolBoxIn(shown, 0.25));
      parameters.load.dimensions = k < unseen ? LoadDimensions::Locked : LoadDimensions::Learnt;
      parameters.load.sizeX = 4.5;
      const Result result = pipeline.process(frame, parameters);
      QCOMPARE(result.load.has_value(), k >= unseen);
      if (k < unseen) {
        withheld = result.scene.maybeLoad > 0;
        QVERIFY(result.clearance.reason == Reason::LoadNotSeen);
      } else if (k < unseen + learning - 1) {
        // The rest of what was withheld is not in the model yet: unknown, not clear.
        QCOMPARE(result.scene.maybeLoad, std::size_t{0});
        QVERIFY(result.clearance.reason == Reason::NoModel);
      } else {
        QVERIFY(result.clearance.nearest);
        BW_COMPARE_NEAR(result.clearance.nearest->distance, *frame->trueDistance, 0.1);
      }
    }
    QVERIFY(withheld);
  }

  /// Who watches the tool as well wants to be warned of what is near it.
  void whereTheToolIsWatchedEverythingTeaches() {
    const YardSource source("as=depth,path=random,seed=3,frames=100");
    TrueTool tool;
    Pipeline pipeline(tool.maker());
    pipeline.order(TrueTool::order());
    Parameters parameters;
    parameters.load.source = LoadSource::Detected;
    parameters.load.dimensions = LoadDimensions::Locked;
    parameters.load.sizeX = 4.5;
    const int before = 6, learning = *framesToEnter(parameters.model);
    for (int k = 0; k < before + learning; ++k) {
      const bool watched = k >= before;
      const YardFrame shown = source.at(static_cast<std::size_t>(k));
      const FramePtr& frame = shown.frame;
      tool.set(toolBoxIn(shown, 0.25));
      parameters.watch.tool = watched;
      const Result result = pipeline.process(frame, parameters);
      QVERIFY(!result.load);
      QCOMPARE(result.scene.maybeLoad > 0, !watched);
      if (!watched) continue;
      // Nor is it clear around the tool before the model knows what was withheld.
      const bool known = k == before + learning - 1;
      QCOMPARE(result.watched.back().clearance.reason == Reason::NoModel, !known);
    }
  }
};

BOOMWATCH_TEST(TestUnseenLoad)
#include "test_unseen_load.moc"
