#include <QtTest>
#include <cstring>
#include <map>

#include "experiments/chain_experiment.h"
#include "experiments/chain_stage.h"
#include "experiments/defaults_experiment.h"
#include "experiments/entry_experiment.h"
#include "experiments/gap_experiment.h"
#include "experiments/hour_experiment.h"
#include "experiments/passing_experiment.h"
#include "experiments/projection_experiment.h"
#include "experiments/search_experiment.h"
#include "experiments/simulator_experiment.h"
#include "experiments/update_rules_experiment.h"
#include "experiments/yard_runs.h"
#include "simulation/yard/depth_cloud.h"
#include "simulation/yard/sensor.h"
#include "yard_frames.h"

using namespace boomwatch;

namespace {

const auto always = [](double) { return true; };

ExperimentSetup little() {
  ExperimentSetup setup;
  setup.sequences = 1;
  setup.frames = 14;
  return setup;
}

Table tableOf(const Chapter& chapter, const std::string& file) {
  for (const auto& item : chapter.items) {
    const auto* table = std::get_if<Table>(&item);
    if (table && table->file == file) return *table;
  }
  return {};
}

std::string cell(const Table& table, const std::string& row, const std::string& heading) {
  const auto column = std::ranges::find(table.headings, heading) - table.headings.begin();
  for (const Cells& cells : table.rows) {
    if (cells[0] == row) return cells.at(static_cast<std::size_t>(column));
  }
  return "no such row";
}

bool samePoints(const Cloud& a, const Cloud& b) {
  return a.points.size() == b.points.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(a.points[0])) == 0;
}

}  // namespace

/// The experiments against closed forms, and against what the thesis measured.
class TestExperimentsCore : public QObject {
  Q_OBJECT

 private slots:
  void framesToEnterAreThoseOfEquation23() {
    const auto chapter = runEntryExperiment({}, always);
    const Table table = tableOf(*chapter, "frames_to_enter");
    QCOMPARE(table.rows.size(), std::size_t{19});
    for (const Cells& row : table.rows) QCOMPARE(row[2], row[1]);
    QCOMPARE(cell(table, "0.50", "Eq. 23"), std::string("4"));
    QCOMPARE(cell(table, "0.65", "Eq. 23"), std::string("11"));
    QCOMPARE(cell(table, "0.70", "Eq. 23"), std::string("never"));
  }

  void theGapIsAsWideAsItsShadow() {
    const auto chapter = runGapExperiment({}, always);
    const Table table = tableOf(*chapter, "gap_behind_near_objects");
    QCOMPARE(table.rows.size(), std::size_t{10});
    for (const Cells& row : table.rows) {
      const double expected = std::stod(row[2]), found = std::stod(row[3]);
      // Both edges fall into cells that are partly seen.
      QVERIFY2(std::abs(expected - found) <= 0.08, row[3].c_str());
    }
  }

  void theSheetAppearsAfterFourFramesAndTheHeadIsAsWideAsItIs() {
    const auto chapter = runPassingExperiment({}, always);
    const Table held = tableOf(*chapter, "swung_sheet");
    for (const Cells& row : held.rows) QCOMPARE(row[3], row[2]);
    QCOMPARE(cell(held, "thesis", "frames to appear"), std::string("4"));
    QCOMPARE(cell(held, "thesis", "frames until it is gone"), std::string("1"));
    QCOMPARE(cell(held, "thesis", "most of it in the model while swung (%)"), std::string("0"));
    // Who runs past a wall is in no place for four frames.
    std::map<std::string, double> running;
    for (const Cells& row : tableOf(*chapter, "walking_past").rows) {
      if (row[0] == "a wall at 5 m" && row[1] == "4.0") running[row[2]] = std::stod(row[4]);
    }
    QCOMPARE(running.size(), std::size_t{3});
    QVERIFY(running["thesis"] > 80.0);
    QVERIFY(running["hysteresis"] < 0.5 * running["thesis"]);
    const Table head = tableOf(*chapter, "head_in_figure_19");
    for (const Cells& row : head.rows) QCOMPARE(row[2], row[1]);
  }

  void theSimulatorMeasuresWhatTheThesisDid() {
    const auto chapter = runSimulatorExperiment(little(), always);
    for (const Cells& row : tableOf(*chapter, "simulator_poses").rows) {
      // A cell and a depth level.
      QVERIFY2(std::abs(std::stod(row[3]) - std::stod(row[1])) <= 0.08, row[0].c_str());
    }
    const Table errors = tableOf(*chapter, "simulator_errors");
    QCOMPARE(errors.rows.size(), std::size_t{8});
    for (const Cells& row : errors.rows) QVERIFY2(std::stoi(row[3]) > 10, row[3].c_str());
    // Exact against what is seen: at worst an edge that lies across its cell, and a depth level.
    for (const std::size_t scene : {0U, 4U}) {
      QCOMPARE(errors.rows[scene][1] + errors.rows[scene][2], std::string("exactwhat is seen"));
      QVERIFY2(std::stod(errors.rows[scene][7]) < 0.1, errors.rows[scene][7].c_str());
    }
  }

  void exactIsExact() {
    const auto chapter = runSearchExperiment(little(), always);
    QCOMPARE(tableOf(*chapter, "search_times").rows.size(), std::size_t{7});
    for (const Cells& row : tableOf(*chapter, "search_over_estimates").rows) {
      QVERIFY(row[8].starts_with("0 of ") && row[8] != "0 of 0");
      QVERIFY(std::stod(row[9]) < 1e-6);
    }
  }

  void flickerAndFalseCellsAreMeasured() {
    ExperimentSetup setup = little();
    setup.frames = 40;
    const auto chapter = runUpdateRulesExperiment(setup, always);
    const Table table = tableOf(*chapter, "update_rules");
    QCOMPARE(table.rows.size(), std::size_t{3});
    for (const Cells& row : table.rows) QVERIFY(std::stoi(row[1]) > 1000);
    const auto flicker = [&](const char* rule) {
      return std::stod(cell(table, rule, "flicker (changes in 100 frames)"));
    };
    QVERIFY(flicker("thesis") > flicker("hysteresis"));
  }

  // What the stages of the chain are given is what the yard's own sources give.
  void theCloudsOfTheStagesAreTheYards() {
    YardFrames yards;
    const FramePtr pair = yards.at("seed=3,frames=4", 2);
    const FramePtr points = yards.at("seed=3,frames=4,as=cloud", 2);
    const FramePtr depth = yards.at("seed=3,frames=4,as=depth", 2);
    const YardTruth& truth = *pair->truth->yard;
    QVERIFY(samePoints(*cloudOf(truth.depth, PinholeCamera{}), *points->cloud));
    cv::Mat noisy = truth.depth.clone();
    addDepthNoise(noisy, 0.2, truth.depthTimesDisparity, depthNoiseStream(3, 2));
    roundToMillimetres(noisy);
    QVERIFY(samePoints(*cloudOf(noisy, PinholeCamera{}), *depth->cloud));
  }

  // Brute force over all pixels, by other means: nothing seen is nearer than all there is.
  void whatIsSeenIsNeverNearerThanWhatIsThere() {
    YardFrames yards;
    for (const std::size_t index : {0U, 3U}) {
      const FramePtr frame = yards.at("seed=3,frames=4", index);
      const ChainFrame truth = truthOf(*frame, nullptr);
      QVERIFY(truth.seen.has_value());
      // A pixel's depth is a float.
      QVERIFY(*truth.seen >= truth.truth - 1e-4);
      QVERIFY(*truth.seen < truth.truth + 1.0);
    }
  }

  void theTrueToolIsWhereItIsSaidToBe() {
    TrueTool tool;
    Pipeline pipeline(tool.maker());
    pipeline.order(TrueTool::order());
    YardFrames yards;
    const FramePtr frame = yards.at("seed=3,frames=4,as=cloud", 0);
    const auto box = toolBoxIn(*frame, 0.2);
    QVERIFY(box.has_value());
    tool.set(box);
    const Result seen = pipeline.process(frame, {});
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

  void bothProjectionsAreMeasuredAgainstTruth() {
    const auto chapter = runProjectionExperiment(little(), always);
    const Table table = tableOf(*chapter, "projections");
    QCOMPARE(table.rows.size(), std::size_t{4});
    for (const Cells& row : table.rows) {
      QVERIFY(std::stod(row[2]) > 50.0);
      QVERIFY2(std::stod(row[4]) < 0.2, row[4].c_str());
    }
  }

  void theDefaultsAreComparedWithTheThesiss() {
    ExperimentSetup setup = little();
    setup.hours = 1.0 / 3600.0;
    const auto chapter = runDefaultsExperiment(setup, always);
    const Table table = tableOf(*chapter, "defaults");
    QCOMPARE(table.rows.size(), std::size_t{9});
    QCOMPARE(table.rows.front()[0] + ": " + table.rows.front()[1],
             std::string("noisy depth: defaults"));
    // Set back it must not do what the default does, as far as so short a run shows it.
    const auto measured = [&](std::size_t row) {
      return Cells(table.rows[row].begin() + 2, table.rows[row].end());
    };
    for (const Cells& row : table.rows) QVERIFY(!row[6].empty());
    for (const std::size_t row : {1U, 4U, 5U}) QVERIFY(measured(row) != measured(0));
    QVERIFY(measured(8) != measured(6));
  }

  void everyExperimentStopsWhenItIsTold() {
    for (const Experiment& experiment : experiments()) {
      int asked = 0;
      const auto chapter = experiment.run(little(), [&](double) { return ++asked < 2; });
      QVERIFY2(!chapter, experiment.name.data());
      QVERIFY2(asked <= 3, experiment.name.data());
    }
  }
};

QTEST_GUILESS_MAIN(TestExperimentsCore)
#include "test_experiments_core.moc"
