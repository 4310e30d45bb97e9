#include <QtTest>
#include <cstring>

#include "lab/experiments/chain_stage.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/yard_plan.h"
#include "simulation/yard/depth_cloud.h"
#include "simulation/yard/yard_sensor.h"
#include "support/experiment_tables.h"
#include "support/test_registry.h"
#include "support/yard_frames.h"

using namespace boomwatch;

namespace {

bool samePoints(const Cloud& a, const Cloud& b) {
  return a.points.size() == b.points.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(a.points[0])) == 0;
}

}  // namespace

/// The chain on random yards: the same each time, and on what it is said to be.
class TestExperimentsChain : public QObject {
  Q_OBJECT

 private slots:
  // What the stages of the chain are given is what the yard's own sources give.
  void theCloudsOfTheStagesAreTheYards() {
    YardFrames yards;
    const YardFrame pair = yards.withTruth("seed=3,frames=4", 2);
    const FramePtr points = yards.at("seed=3,frames=4,as=cloud", 2);
    const FramePtr depth = yards.at("seed=3,frames=4,as=depth", 2);
    const YardTruth& truth = *pair.truth;
    QVERIFY(samePoints(*cloudOf(truth.depth, demoCamera), *points->cloud));
    cv::Mat noisy = truth.depth.clone();
    addDepthNoise(noisy, 0.2, truth.depthTimesDisparity, depthNoiseStream(3, 2));
    roundToMillimetres(noisy);
    QVERIFY(samePoints(*cloudOf(noisy, demoCamera), *depth->cloud));
  }

  // Brute force over all pixels, by other means: nothing seen is nearer than all there is.
  void whatIsSeenIsNeverNearerThanWhatIsThere() {
    YardFrames yards;
    for (const std::size_t index : {0U, 3U}) {
      const ChainFrame truth = truthOf(yards.withTruth("seed=3,frames=4", index), {});
      QVERIFY(truth.seen.has_value());
      // A pixel's depth is a float.
      QVERIFY(*truth.seen >= truth.truth - 1e-4);
      QVERIFY(*truth.seen < truth.truth + 1.0);
      // A patch is somewhat farther away than its nearest point; here it is on the ground.
      QVERIFY(truth.patch && *truth.patch >= *truth.seen && *truth.patch < *truth.seen + 0.1);
    }
  }

  void theTrueToolIsWhereItIsSaidToBe() {
    TrueTool tool;
    Pipeline pipeline(tool.maker());
    pipeline.order(TrueTool::order());
    YardFrames yards;
    const YardFrame shown = yards.withTruth("seed=3,frames=4,as=cloud", 0);
    const auto box = toolBoxIn(shown, 0.2);
    QVERIFY(box.has_value());
    tool.set(box);
    const Result seen = pipeline.process(shown.frame, {});
    QVERIFY(seen.tool.box == box);
    tool.set(std::nullopt);
    const Result lost = pipeline.process(yards.at("seed=3,frames=4,as=cloud", 1), {});
    QVERIFY(lost.tool.state == TrackState::Lost);
  }

  void theChainIsRepeatable() {
    const auto first = runChainExperiment(little(), always);
    const auto second = runChainExperiment(little(), always);
    const Table frames = tableOf(*first, "chain_frames");
    QCOMPARE(frames.rows.size(), chainKinds.size() * 14);
    QVERIFY(frames.rows == tableOf(*second, "chain_frames").rows);
    QCOMPARE(tableOf(*first, "chain_alarms").rows.size(), chainKinds.size());
  }

  // Two yards at a time: the outcome is in order, and that of each yard by itself.
  void yardsDoNotDisturbEachOther() {
    YardPlan plan{3, 3, 8, {{ChainKind::NoisyDepth, {}}, {ChainKind::MaskedCloud, {}}}};
    const auto runs = runYards(plan, always);
    QCOMPARE(runs->size(), std::size_t{6});
    for (std::size_t k = 0; k < runs->size(); ++k) {
      QCOMPARE((*runs)[k].seed, 3 + k / 2);
      QVERIFY((*runs)[k].kind == plan.stages[k % 2].kind);
      QCOMPARE((*runs)[k].frames.size(), std::size_t{8});
    }
    plan.firstSeed = 5;
    plan.yards = 1;
    const auto alone = runYards(plan, always);
    for (std::size_t k = 0; k < 2; ++k) {
      QVERIFY(chainFrames(std::span(*alone).subspan(k, 1)).rows ==
              chainFrames(std::span(*runs).subspan(4 + k, 1)).rows);
    }
  }

  void anHourIsAsLongAsItIsSaidToBe() {
    ExperimentSetup setup = little();
    setup.hours = 30.0 / 20.0 / 3600.0;
    const auto chapter = runHourExperiment(setup, always);
    QCOMPARE(tableOf(*chapter, "hour_chain_frames").rows.size(), std::size_t{2 * 30});
    const Table alarms = tableOf(*chapter, "hour_chain_alarms");
    QCOMPARE(alarms.rows.size(), std::size_t{2});
    QCOMPARE(cell(alarms, "truth cloud", "missed"), std::string("0"));
    QCOMPARE(cell(alarms, "noisy depth", "missed"), std::string("0"));
  }

  void theDefaultsAreComparedWithTheThesiss() {
    ExperimentSetup setup = little();
    setup.hours = 1.0 / 3600.0;
    setup.frames = 24;
    const auto chapter = runDefaultsExperiment(setup, always);
    const Table table = tableOf(*chapter, "defaults");
    QCOMPARE(table.rows.size(), std::size_t{12});
    QCOMPARE(table.rows.front()[0] + ": " + table.rows.front()[1],
             std::string("noisy depth: defaults"));
    // Set back it must not do what the default does, as far as so short a run shows it.
    const auto measured = [&](std::size_t row) {
      return Cells(table.rows[row].begin() + 2, table.rows[row].end());
    };
    for (const Cells& row : table.rows) QVERIFY(!row[6].empty());
    for (const std::size_t row : {1U, 2U, 5U, 6U}) {
      QVERIFY2(measured(row) != measured(0), table.rows[row][1].c_str());
    }
    QVERIFY(measured(10) != measured(7));
  }
};

BOOMWATCH_TEST(TestExperimentsChain)
#include "test_experiments_chain.moc"
