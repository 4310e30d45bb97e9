#include <QtTest>
#include <random>

#include "environment/environment_model.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;

Q_DECLARE_METATYPE(boomwatch::ModelUpdate)

namespace {

const GridGeometry grid{{0.0, 1.0, 0.0, 1.0, 0.5, 3.0}, 0.05};

ModelParameters with(ModelUpdate update) { return {.update = update}; }

/// The middle of cell (column, row) at depth level 100.
Eigen::Vector3f inCell(int column, int row) {
  return grid.surfacePoint(column, row, 100).cast<float>();
}

Eigen::Vector3f throughCell(int column, int row) {
  Eigen::Vector3f point = inCell(column, row);
  point.z() = 50.0F;
  return point;
}

double odds(double probability) { return probability / (1.0 - probability); }

/// Frames until the cell (3, 3) of `model` is (or is no longer) occupied; -1 if that never comes.
int framesUntil(EnvironmentModel& model, const ModelParameters& parameters, bool occupied,
                const Points& points) {
  for (int frame = 1; frame <= 3000; ++frame) {
    model.update(points, parameters);
    if ((model.state(3, 3) == CellState::Occupied) == occupied) return frame;
  }
  return -1;
}

EnvironmentModel seenForLong(const ModelParameters& parameters) {
  EnvironmentModel model(grid);
  for (int frame = 0; frame < 300; ++frame) model.update(Points{inCell(3, 3)}, parameters);
  return model;
}

/// The rules one cell at a time, in doubles, as docs/method.md and Bayes' rule have them.
class PlainCell {
 public:
  explicit PlainCell(const ModelParameters& parameters) : m_parameters(parameters) {}

  void see(bool measured) {
    const ModelParameters& p = m_parameters;
    if (p.update == ModelUpdate::LogOdds) {
      if (measured) probability = std::max(probability, p.logOddsLow);
      const double seen = odds(probability) * odds(measured ? p.logOddsHit : p.logOddsMiss);
      probability = std::min(seen / (1.0 + seen), p.logOddsHigh);
    } else {
      probability = p.pPost * probability + (measured ? p.pPrior : 0.0);
    }
    if (probability < double{observedFloor}) probability = 0.0;
    occupied = probability > limit();
  }
  /// What the probability has to exceed for the cell to be occupied after the next frame.
  double limit() const {
    return m_parameters.update == ModelUpdate::Hysteresis && occupied ? m_parameters.leaveThreshold
                                                                      : m_parameters.probtresh;
  }

  double probability = 0.0;
  bool occupied = false;

 private:
  ModelParameters m_parameters;
};

/// One cell, one frame of hysteresis; `nearness` is 256 - level of what was measured, or 0.
void stepPlainly(float& probability, std::uint8_t& level, int nearness,
                 const ModelParameters& parameters) {
  const auto kept = static_cast<float>(parameters.pPost);
  const auto hit = static_cast<float>(parameters.pPrior);
  const auto leave = static_cast<float>(parameters.leaveThreshold);
  const int measured = nearness > 0 ? 256 - nearness : 0;
  const bool both = measured > 0 && level > 0;
  const bool before = both && level - measured > sameSurface;
  const bool behind = both && measured - level > sameSurface;
  const bool same = measured > 0 && !before && !behind;
  float seenOften = 0.0F;
  auto leftOfSurface = static_cast<float>(parameters.pPrior / (1.0 - parameters.pPost)) * 1.001F;
  for (int n = framesToEnter(parameters).value(); n > 0; --n) {
    seenOften = kept * seenOften + hit;
    leftOfSurface *= kept;
  }
  const float updated = kept * probability + (same ? hit : 0.0F);
  const bool replaced = (before && updated <= leftOfSurface) || (behind && updated <= leave);
  probability = replaced ? seenOften : updated < observedFloor ? 0.0F : updated;
  const bool occupied =
      probability > (level > 0 ? leave : static_cast<float>(parameters.probtresh));
  if (replaced || (same && level == 0)) {
    level = static_cast<std::uint8_t>(measured);
  } else if (same && measured != level) {
    level = static_cast<std::uint8_t>(level + (measured > level ? 1 : -1));
  }
  if (!occupied) level = 0;
}

}  // namespace

class TestCellUpdate : public QObject {
  Q_OBJECT

 private slots:
  void everyUpdateEqualsItsRule_data() { eachUpdate(); }
  void everyUpdateEqualsItsRule() {
    QFETCH(ModelUpdate, update);
    const ModelParameters parameters = with(update);
    EnvironmentModel model(grid);
    std::vector<PlainCell> plain(grid.cellCount(), PlainCell(parameters));
    std::mt19937 random(7);
    for (int frame = 0; frame < 300; ++frame) {
      Points points;
      for (std::size_t k = 0; k < plain.size(); ++k) {
        const int column = static_cast<int>(k % 20), row = static_cast<int>(k / 20);
        // Each row is seen more often than the one above it; now and then all go blind for long.
        const bool measured = frame % 100 < 70 && random() % 20 < static_cast<unsigned>(row);
        if (measured) points.push_back(inCell(column, row));
        plain[k].see(measured);
      }
      model.update(points, parameters);
      for (std::size_t k = 0; k < plain.size(); ++k) {
        BW_COMPARE_NEAR(model.probabilities()[k], plain[k].probability, 1e-5);
        QCOMPARE(model.levels()[k] > 0, plain[k].occupied);
      }
    }
  }

  // n: how often in a row a thing must be seen. m: how often it must be missed.
  void hysteresisEntersAndLeavesAsItsThresholdsSay() {
    for (const double leave : {0.05, 0.1, 0.2, 0.3, 0.45}) {
      ModelParameters parameters = with(ModelUpdate::Hysteresis);
      parameters.leaveThreshold = leave;
      EnvironmentModel model(grid);
      QCOMPARE(framesUntil(model, parameters, true, {inCell(3, 3)}), 4);
      QCOMPARE(framesToEnter(parameters), std::optional(4));
      model = seenForLong(parameters);
      const int misses = static_cast<int>(std::ceil(std::log(leave / (2.0 / 3.0)) / std::log(0.7)));
      QCOMPARE(framesUntil(model, parameters, false, {}), misses);
    }
  }

  /// Frames of `sight` until the surface of cell (3, 3), long seen at level `from`, is at `to`.
  static int framesUntilLevel(int from, int to, const std::vector<Points>& sights) {
    const ModelParameters parameters = with(ModelUpdate::Hysteresis);
    EnvironmentModel model(grid);
    for (int frame = 0; frame < 300; ++frame) model.update(Points{at(from)}, parameters);
    for (int frame = 1; frame <= 100; ++frame) {
      model.update(sights[static_cast<std::size_t>(frame - 1) % sights.size()], parameters);
      if (std::abs(model.levels()[grid.index(3, 3)] - to) <= 1) return frame;
    }
    return -1;
  }
  static Eigen::Vector3f at(int level) { return grid.surfacePoint(3, 3, level).cast<float>(); }

  void hysteresisInDepth() {
    // Before a surface a thing must be seen as often as before nothing; behind it, 6 misses let go.
    QCOMPARE(framesUntilLevel(200, 100, {{at(100)}}), 4);
    QCOMPARE(framesUntilLevel(100, 200, {{at(200)}}), 6);
    // A leaf that falls past in three frames, again and again: never.
    const Points ground{at(200)}, leaf{at(100)};
    QCOMPARE(framesUntilLevel(200, 100, {leaf, leaf, leaf, ground, ground, ground, ground}), -1);
    // A thin thing that is missed in one frame of five enters, and stays.
    QVERIFY(framesUntilLevel(200, 100, {leaf, leaf, leaf, ground, leaf}) > 0);
    QCOMPARE(framesUntilLevel(100, 200, {leaf, leaf, leaf, leaf, ground}), -1);
    // Noise does not count as another surface; what is a little nearer is followed by a level a
    // frame, and so a leaf that falls past right before a wall does not come near.
    QCOMPARE(framesUntilLevel(200, 193, {{at(193)}}), 6);
    QCOMPARE(framesUntilLevel(193, 200, {{at(200)}}), 6);
    const Points close{at(193)};
    QCOMPARE(framesUntilLevel(200, 193, {close, close, close, ground, ground, ground}), -1);
  }

  // The rule as its header words it, one cell at a time, against what is computed in blocks.
  void hysteresisOfAnyLevelsEqualsItsRule() {
    const ModelParameters parameters = with(ModelUpdate::Hysteresis);
    constexpr std::size_t cells = 1300;  // two blocks and a bit
    std::vector<float> probabilities(cells), expected(cells);
    std::vector<std::uint8_t> levels(cells), expectedLevels(cells), nearness(cells);
    std::mt19937 random(5);
    int surfaces = 0;
    for (int frame = 0; frame < 400; ++frame) {
      for (std::size_t k = 0; k < cells; ++k) {
        // A surface with noise that is missed at times, and now and then for long; blank cells,
        // too.
        const int about = 20 + static_cast<int>(k % 13) * 18 + (frame / 60 % 2 == 0 ? 0 : 12);
        const bool blank = k >= 512 && k < 1024 && frame < 100;  // a whole block
        const bool seen = !blank && k % 7 != 0 && frame % 90 < 75 && random() % 5 > 0;
        const int level = random() % 6 == 0 ? 1 + static_cast<int>(random() % 255)
                                            : about - 2 + static_cast<int>(random() % 5);
        nearness[k] = static_cast<std::uint8_t>(seen ? 256 - std::clamp(level, 1, 255) : 0);
        stepPlainly(expected[k], expectedLevels[k], nearness[k], parameters);
      }
      updateCells(probabilities, levels, nearness, parameters);
      for (std::size_t k = 0; k < cells; ++k) {
        QVERIFY(probabilities[k] == expected[k]);  // to the last bit
        QCOMPARE(int{levels[k]}, int{expectedLevels[k]});
        QCOMPARE(int{nearness[k]}, 0);
        surfaces += levels[k] > 0;
      }
    }
    QVERIFY(surfaces > 100'000);
  }

  void logOddsEnterAndLeaveAsTheirClampsSay() {
    for (const double limit : {0.3, 0.5, 0.8}) {
      ModelParameters parameters = with(ModelUpdate::LogOdds);
      parameters.probtresh = limit;
      const double hits = std::log(odds(limit) / odds(0.12)) / std::log(odds(0.7));
      const int n = static_cast<int>(std::floor(hits)) + 1;
      EnvironmentModel model(grid);
      QCOMPARE(framesUntil(model, parameters, true, {inCell(3, 3)}), n);
      QCOMPARE(framesToEnter(parameters), std::optional(n));
      model = seenForLong(parameters);
      const double misses = std::log(odds(limit) / odds(0.97)) / std::log(odds(0.4));
      QCOMPARE(framesUntil(model, parameters, false, {}), static_cast<int>(std::ceil(misses)));
    }
  }

  void aCellSeenInFourOfFiveFramesFlickersInTheThesissOnly_data() {
    QTest::addColumn<ModelUpdate>("update");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    // Leaving takes five or six misses in a row: once in some 4000 frames.
    QTest::newRow("thesis") << ModelUpdate::Thesis << 24.0 << 28.0;
    QTest::newRow("hysteresis") << ModelUpdate::Hysteresis << 0.0 << 0.2;
    QTest::newRow("log-odds") << ModelUpdate::LogOdds << 0.0 << 0.0;
  }
  void aCellSeenInFourOfFiveFramesFlickersInTheThesissOnly() {
    QFETCH(ModelUpdate, update);
    const ModelParameters parameters = with(update);
    EnvironmentModel model = seenForLong(parameters);
    std::mt19937 random(11);
    std::bernoulli_distribution seen(0.8);
    int changes = 0;
    constexpr int frames = 2000;
    for (int frame = 0; frame < frames; ++frame) {
      const CellState before = model.state(3, 3);
      model.update(seen(random) ? Points{inCell(3, 3)} : Points{}, parameters);
      changes += model.state(3, 3) != before;
    }
    QFETCH(double, least);
    QFETCH(double, most);
    const double perHundred = 100.0 * changes / frames;
    QVERIFY2(perHundred >= least && perHundred <= most, qPrintable(QString::number(perHundred)));
  }

  void aHiddenCellStaysAsItIs_data() { eachUpdate(); }
  void aHiddenCellStaysAsItIs() {
    QFETCH(ModelUpdate, update);
    EnvironmentModel model = seenForLong(with(update));
    const float before = model.probabilities()[grid.index(3, 3)];
    Eigen::Vector3f load = inCell(3, 3);
    load.z() = 1.0F;
    for (int frame = 0; frame < 100; ++frame) model.update({}, with(update), Points{load});
    QCOMPARE(model.state(3, 3), CellState::Occupied);
    QCOMPARE(model.probabilities()[grid.index(3, 3)], before);
  }

  // Missed three times before it was hidden: what is left of a load that has passed.
  void whatIsOnItsWayOutIsNotHeld() {
    const ModelParameters parameters = with(ModelUpdate::Hysteresis);
    EnvironmentModel model = seenForLong(parameters);
    for (int frame = 0; frame < 3; ++frame) model.update({}, parameters);
    QCOMPARE(model.state(3, 3), CellState::Occupied);
    Eigen::Vector3f load = inCell(3, 3);
    load.z() = 1.0F;
    for (int frame = 0; frame < 3; ++frame) model.update({}, parameters, Points{load});
    QVERIFY(model.state(3, 3) != CellState::Occupied);
  }

  void blindnessIsForgottenAndLookingThroughIsFree_data() { eachUpdate(); }
  void blindnessIsForgottenAndLookingThroughIsFree() {
    QFETCH(ModelUpdate, update);
    EnvironmentModel model = seenForLong(with(update));
    for (int frame = 0; frame < 40; ++frame) model.update(Points{throughCell(5, 5)}, with(update));
    QCOMPARE(model.state(3, 3), CellState::NeverObserved);
    QCOMPARE(model.state(5, 5), CellState::ObservedFree);
    QCOMPARE(model.state(9, 9), CellState::NeverObserved);
  }

  void whatIsSaidOfAThresholdIsWhatHappens_data() { eachUpdate(); }
  void whatIsSaidOfAThresholdIsWhatHappens() {
    QFETCH(ModelUpdate, update);
    int never = 0, stuck = 0;
    for (const double limit : {0.0, 0.003, 0.006, 0.008, 0.3, 0.66, 0.67, 0.96, 0.97, 1.0}) {
      ModelParameters parameters = with(update);
      parameters.probtresh = limit;
      EnvironmentModel model(grid);
      const int entered = framesUntil(model, parameters, true, {inCell(3, 3)});
      QCOMPARE(entered, framesToEnter(parameters).value_or(-1));
      never += entered < 0;
      if (entered < 0) continue;
      QCOMPARE(framesUntil(model, parameters, false, {throughCell(3, 3)}) > 0, letsGo(parameters));
      stuck += !letsGo(parameters);
    }
    QVERIFY(never > 0);
    QCOMPARE(stuck > 0, update != ModelUpdate::Hysteresis);
  }

  void theHighestProbabilityIsReached_data() { eachUpdate(); }
  void theHighestProbabilityIsReached() {
    QFETCH(ModelUpdate, update);
    const float reached = seenForLong(with(update)).probabilities()[grid.index(3, 3)];
    BW_COMPARE_NEAR(reached, maxProbability(with(update)), 1e-5);
  }

  // The thesis's probabilities are not bounded by 1: whoever changes the update in the middle of a
  // recording must get a model all the same.
  void anyProbabilityIsTakenOver() {
    ModelParameters parameters;
    parameters.pPrior = 1.0;
    parameters.pPost = 0.999;
    EnvironmentModel model = seenForLong(parameters);
    QVERIFY(model.probabilities()[grid.index(3, 3)] > 100.0F);
    parameters = with(ModelUpdate::LogOdds);
    model.update(Points{inCell(3, 3)}, parameters);
    QCOMPARE(model.probabilities()[grid.index(3, 3)], 0.97F);
    QVERIFY(framesUntil(model, parameters, false, {}) > 0);
  }

 private:
  static void eachUpdate() {
    QTest::addColumn<ModelUpdate>("update");
    QTest::newRow("thesis") << ModelUpdate::Thesis;
    QTest::newRow("hysteresis") << ModelUpdate::Hysteresis;
    QTest::newRow("log-odds") << ModelUpdate::LogOdds;
  }
};

BOOMWATCH_TEST(TestCellUpdate)
#include "test_cell_update.moc"
