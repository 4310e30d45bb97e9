#include <QtTest>
#include <map>

#include "lab/experiments/experiments.h"
#include "support/experiment_tables.h"
#include "support/test_registry.h"

using namespace boomwatch;

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

  void bothProjectionsAreMeasuredAgainstTruth() {
    const auto chapter = runProjectionExperiment(little(), always);
    const Table table = tableOf(*chapter, "projections");
    QCOMPARE(table.rows.size(), std::size_t{4});
    for (const Cells& row : table.rows) {
      QVERIFY(std::stod(row[2]) > 50.0);
      QVERIFY2(std::stod(row[4]) < 0.2, row[4].c_str());
    }
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

BOOMWATCH_TEST(TestExperimentsCore)
#include "test_experiments_core.moc"
