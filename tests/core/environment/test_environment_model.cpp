#include <QtTest>
#include <random>

#include "environment/environment_model.h"
#include "support/test_registry.h"

using boomwatch::Bounds;
using boomwatch::CellState;
using boomwatch::EnvironmentModel;
using boomwatch::framesToEnter;
using boomwatch::GridGeometry;
using boomwatch::ModelParameters;
using boomwatch::ModelUpdate;
using boomwatch::Points;

namespace {

const Bounds smallBounds{-1.0, 1.0, -0.8, 0.7, 0.5, 3.0};

/// Eq. 8 to 11 as they are printed (with the errata), one cell at a time in doubles; beyond them,
/// what was not seen for long is forgotten, and a point behind zMax leaves a trace.
class PlainModel {
 public:
  explicit PlainModel(const GridGeometry& geometry)
      : m_geometry(geometry), probability(geometry.cellCount()), level(geometry.cellCount()) {}

  void update(const Points& points, const ModelParameters& parameters) {
    std::vector<int> measured(probability.size(), 0);
    const Bounds& b = m_geometry.bounds();
    for (const auto& p : points) {
      if (!boomwatch::isMeasured(p) || p.z() < b.zMin) continue;
      const double i = std::floor((p.x() - b.xMin) / m_geometry.resolution() + 1e-9);
      const double j = std::floor((p.y() - b.yMin) / m_geometry.resolution() + 1e-9);
      if (i < 0 || j < 0 || i >= m_geometry.columns() || j >= m_geometry.rows()) continue;
      const std::size_t k = m_geometry.index(static_cast<int>(i), static_cast<int>(j));
      if (p.z() > b.zMax) {
        probability[k] = std::max(probability[k], double{boomwatch::seenThrough});
        continue;
      }
      const double depth = std::round(255.0 * (p.z() - b.zMin) / (b.zMax - b.zMin));
      const int here = std::max(1, static_cast<int>(depth));
      int& cell = measured[k];
      cell = cell == 0 ? here : std::min(cell, here);
    }
    for (std::size_t k = 0; k < probability.size(); ++k) {
      probability[k] = parameters.pPost * probability[k] + (measured[k] ? parameters.pPrior : 0.0);
      if (probability[k] < double{boomwatch::observedFloor}) probability[k] = 0.0;
      if (probability[k] <= parameters.probtresh) {
        level[k] = 0;
      } else if (measured[k]) {
        level[k] = measured[k];
      }
    }
  }

 private:
  GridGeometry m_geometry;

 public:
  std::vector<double> probability;
  std::vector<int> level;
};

Points randomFrame(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<float> x(-1.1F, 1.1F);
  std::uniform_real_distribution<float> y(-0.9F, 0.8F);
  std::uniform_real_distribution<float> z(0.4F, 3.2F);
  Points points;
  while (points.size() < count) points.emplace_back(x(random), y(random), z(random));
  return points;
}

/// A point in the middle of a cell, at the middle of a depth level.
Eigen::Vector3f inCell(const EnvironmentModel& model, int column, int row, int level) {
  return model.geometry().surfacePoint(column, row, level).cast<float>();
}

}  // namespace

class TestEnvironmentModel : public QObject {
  Q_OBJECT

 private slots:
  void updateEqualsEquations8To11_data() {
    QTest::addColumn<double>("resolution");
    QTest::addColumn<double>("pPrior");
    QTest::addColumn<double>("pPost");
    QTest::newRow("the thesis's values") << 0.04 << 0.2 << 0.7;
    QTest::newRow("fine cells") << 0.01 << 0.2 << 0.7;
    QTest::newRow("nothing is left of the past") << 0.05 << 0.7 << 0.0;
    QTest::newRow("hardly anything is forgotten") << 0.05 << 0.002 << 0.999;
  }
  void updateEqualsEquations8To11() {
    QFETCH(double, resolution);
    ModelParameters parameters{.update = ModelUpdate::Thesis};
    QFETCH(double, pPrior);
    QFETCH(double, pPost);
    parameters.pPrior = pPrior;
    parameters.pPost = pPost;
    EnvironmentModel model(GridGeometry(smallBounds, resolution));
    PlainModel plain(model.geometry());
    std::mt19937 random(4);
    for (int frame = 0; frame < 200; ++frame) {
      const Points points = randomFrame(random, frame % 10 == 0 ? 0 : 3000);
      model.update(points, parameters);
      plain.update(points, parameters);
      for (std::size_t k = 0; k < plain.level.size(); ++k) {
        const double difference = std::abs(model.probabilities()[k] - plain.probability[k]);
        QVERIFY(difference < 1e-6);
        // Within rounding of the threshold either side is right.
        if (std::abs(plain.probability[k] - parameters.probtresh) < 1e-6) continue;
        QCOMPARE(static_cast<int>(model.levels()[k]), plain.level[k]);
      }
    }
    QCOMPARE(model.frames(), std::size_t{200});
  }

  void theNearestPointOfACellWins() {
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    const ModelParameters parameters{.probtresh = 0.1, .update = ModelUpdate::Thesis};
    model.update(Points{inCell(model, 3, 4, 90), inCell(model, 3, 4, 20), inCell(model, 3, 4, 200)},
                 parameters);
    QCOMPARE(model.levels()[model.geometry().index(3, 4)], std::uint8_t{20});
  }

  void everyLevelIsKeptFrom1To255() {
    EnvironmentModel model(GridGeometry(Bounds{0, 2.55, 0, 0.01, 0.5, 3.0}, 0.01));
    Points points;
    for (int level = 1; level <= 255; ++level) points.push_back(inCell(model, level - 1, 0, level));
    model.update(points, ModelParameters{.probtresh = 0.1, .update = ModelUpdate::Thesis});
    for (int level = 1; level <= 255; ++level) {
      QCOMPARE(int(model.levels()[model.geometry().index(level - 1, 0)]), level);
    }
  }

  void aThingEntersAfterFourFramesAndLeavesAfterOneMiss() {
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    const ModelParameters parameters{.update = ModelUpdate::Thesis};
    const Points seen{inCell(model, 7, 7, 100)};
    for (int frame = 1; frame <= 20; ++frame) {
      model.update(seen, parameters);
      QCOMPARE(model.state(7, 7) == CellState::Occupied, frame >= *framesToEnter(parameters));
    }
    model.update({}, parameters);  // from 0.667 to 0.467: the thesis's known weakness
    QCOMPARE(model.state(7, 7), CellState::ObservedFree);
  }

  void anUnseenCellKeepsItsLevelWhileItIsProbable() {
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    const ModelParameters parameters{.probtresh = 0.3, .update = ModelUpdate::Thesis};
    for (int frame = 0; frame < 10; ++frame)
      model.update(Points{inCell(model, 2, 3, 50)}, parameters);
    model.update({}, parameters);
    model.update({}, parameters);  // 0.65 -> 0.45 -> 0.32
    QCOMPARE(model.levels()[model.geometry().index(2, 3)], std::uint8_t{50});
    model.update({}, parameters);
    QCOMPARE(model.levels()[model.geometry().index(2, 3)], std::uint8_t{0});
  }

  void neverObservedObservedFreeAndOccupiedAreThreeThings() {
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    const ModelParameters parameters{.update = ModelUpdate::Thesis};
    Eigen::Vector3f through = inCell(model, 5, 5, 255);
    through.z() = 50.0F;
    const Points points{inCell(model, 1, 1, 10), through};
    for (int frame = 0; frame < 5; ++frame) model.update(points, parameters);
    QCOMPARE(model.state(1, 1), CellState::Occupied);
    QCOMPARE(model.state(5, 5), CellState::ObservedFree);
    QCOMPARE(model.state(9, 9), CellState::NeverObserved);
  }

  void whatIsNoLongerMeasuredIsForgottenNotFree() {
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    const ModelParameters parameters{.update = ModelUpdate::Thesis};
    Eigen::Vector3f through = inCell(model, 5, 5, 255);
    through.z() = 50.0F;
    const Points both{inCell(model, 1, 1, 10), through};
    for (int frame = 0; frame < 50; ++frame) model.update(both, parameters);
    // Eq. (8) from its fixed point: 2/3 x 0.7^n < 0.001 from n = 19 on.
    for (int frame = 0; frame < 18; ++frame) model.update(Points{through}, parameters);
    QCOMPARE(model.state(1, 1), CellState::ObservedFree);
    model.update(Points{through}, parameters);
    QCOMPARE(model.state(1, 1), CellState::NeverObserved);
    QCOMPARE(model.state(5, 5), CellState::ObservedFree);  // as long as it is seen through
    for (int frame = 0; frame < 30; ++frame) model.update({}, parameters);
    QCOMPARE(model.state(5, 5), CellState::NeverObserved);
  }

  void lookingThroughACellDoesNotOccupyIt() {
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    Points points{inCell(model, 5, 5, 255)};
    points.front().z() = std::nextafter(3.0F, 4.0F);
    for (int frame = 0; frame < 50; ++frame) model.update(points, ModelParameters{});
    QCOMPARE(model.state(5, 5), CellState::ObservedFree);
    QVERIFY(model.probabilities()[model.geometry().index(5, 5)] <= boomwatch::seenThrough);
  }

  void whatIsNotAPointInTheBoundsIsIgnored() {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::nanf("");
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    Points points;
    for (const float bad : {nan, infinity, -infinity, 1e30F, -1e30F}) {
      points.insert(points.end(), {{bad, 0, 1}, {0, bad, 1}, {bad, bad, bad}});
    }
    for (const float bad : {nan, infinity, -infinity, -1e30F, 0.49F})
      points.emplace_back(0, 0, bad);
    model.update(points, ModelParameters{.probtresh = 0.1, .update = ModelUpdate::Thesis});
    QVERIFY(std::all_of(model.probabilities().begin(), model.probabilities().end(),
                        [](float p) { return p == 0.0F; }));
  }

  void aGridWithoutCellsTakesFrames() {
    EnvironmentModel model(GridGeometry(smallBounds, 100.0));
    model.update(Points{{0, 0, 1}}, ModelParameters{});
    QVERIFY(model.levels().empty());
  }

  void whatIsMaskedHidesWhatIsBehindItOnly() {
    const ModelParameters parameters{.update = ModelUpdate::Thesis};
    const GridGeometry geometry(smallBounds, 0.05);
    const int near = 60, middle = 120, far = 240;  // levels of 1 cm
    const auto statesAfter = [&](int masked) {
      EnvironmentModel model(geometry);
      for (int n = 0; n < 6; ++n) model.update(Points{inCell(model, 1, 1, middle)}, parameters);
      for (int n = 0; n < 3; ++n) model.update({}, parameters, Points{inCell(model, 1, 1, masked)});
      return model.state(1, 1);
    };
    QCOMPARE(statesAfter(near), CellState::Occupied);
    QCOMPARE(statesAfter(middle), CellState::Occupied);
    QCOMPARE(statesAfter(middle + 10), CellState::Occupied);  // the load has entered it
    QCOMPARE(statesAfter(far), CellState::ObservedFree);
  }

  void copiesAreIndependent() {
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    const EnvironmentModel copy = model;
    model.set(1, 2, 0.6F, 77);
    QCOMPARE(model.state(1, 2), CellState::Occupied);
    QCOMPARE(copy.state(1, 2), CellState::NeverObserved);
  }

  void framesToEnterIsEquation23() {
    QCOMPARE(framesToEnter(ModelParameters{}), std::optional(4));
    for (const double post : {0.0, 0.3, 0.7, 0.9, 0.99}) {
      for (const double prior : {0.05, 0.2, 0.9}) {
        for (double limit = 0.011; limit < 1.0; limit += 0.05) {
          const ModelParameters parameters{.probtresh = limit, .pPrior = prior, .pPost = post};
          double sum = 0.0;
          int frames = 0;
          while (sum <= limit && frames < 10'000) {
            sum = post * sum + prior;
            ++frames;
          }
          const auto expected = sum > limit ? std::optional(frames) : std::nullopt;
          QCOMPARE(framesToEnter(parameters), expected);
        }
      }
    }
  }

  void nothingEntersAtOrAboveTheFixedPoint() {
    ModelParameters parameters{.probtresh = 0.2 / (1.0 - 0.7)};
    QCOMPARE(framesToEnter(parameters), std::nullopt);
    EnvironmentModel model(GridGeometry(smallBounds, 0.05));
    for (int frame = 0; frame < 1000; ++frame)
      model.update(Points{inCell(model, 1, 1, 9)}, parameters);
    QCOMPARE(model.state(1, 1), CellState::ObservedFree);
    parameters.probtresh = 0.66;
    QVERIFY(framesToEnter(parameters).has_value());
  }
};

BOOMWATCH_TEST(TestEnvironmentModel)
#include "test_environment_model.moc"
