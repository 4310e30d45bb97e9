#include <QtTest>
#include <map>
#include <queue>

#include "environment/components.h"
#include "support/collision_scenes.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

const GridGeometry grid{{0, 2, 0, 1.5, 0, 5}, 0.05};

/// A full piece by walking from cell to cell, the plain way.
std::vector<std::size_t> walk(const EnvironmentModel& model, std::size_t start, int tolerance) {
  const GridGeometry& g = model.geometry();
  const auto levels = model.levels();
  std::vector<bool> seen(levels.size());
  std::vector<std::size_t> cells;
  std::queue<std::size_t> next;
  next.push(start);
  seen[start] = true;
  while (!next.empty()) {
    const std::size_t k = next.front();
    next.pop();
    cells.push_back(k);
    const int column = static_cast<int>(k) % g.columns(), row = static_cast<int>(k) / g.columns();
    for (int j = row - 1; j <= row + 1; ++j) {
      for (int i = column - 1; i <= column + 1; ++i) {
        if (!g.contains(i, j)) continue;
        const std::size_t other = g.index(i, j);
        if (seen[other] || levels[other] == 0) continue;
        if (std::abs(levels[other] - levels[k]) > tolerance) continue;
        seen[other] = true;
        next.push(other);
      }
    }
  }
  return cells;
}

Evidence at(const Components& pieces, int column, int row, double z) {
  const auto evidence = pieces.evidenceAt(grid.surfacePoint(column, row, grid.levelOf(z)));
  return evidence.value_or(Evidence{});
}

}  // namespace

class TestComponents : public QObject {
  Q_OBJECT
 private slots:
  void equalsAWalkFromCellToCell();
  void aLoneCellCountsLessThanTheGround();
  void aStepInDepthParts();
  void whatIsSmallIsNamed();
  void whatIsNotLargeMustBeCertain();
  void aRimThatComesAndGoesLeavesThePieceCertain();
  void aTrailIsNoThingForTheFewCellsThatAreCertain();
  void nothingIsBehindAFreeCell();
  void cellsFinerThanThePixelsAreOnePiece();
};

void TestComponents::equalsAWalkFromCellToCell() {
  scenes::Random random(3);
  for (const double share : {0.2, 0.35, 0.5, 0.9}) {
    EnvironmentModel model(grid);
    for (int j = 0; j < grid.rows(); ++j) {
      for (int i = 0; i < grid.columns(); ++i) {
        if (scenes::uniform(random, 0, 1) > share) continue;
        scenes::occupy(model, i, j, scenes::uniform(random, 2.0, 2.3));
      }
    }
    Components pieces;
    pieces.rebuild(model, 0.1);
    const int tolerance = static_cast<int>(0.1 / grid.levelStep());
    for (int j = 0; j < grid.rows(); ++j) {
      for (int i = 0; i < grid.columns(); ++i) {
        const std::size_t k = grid.index(i, j);
        if (model.levels()[k] == 0) continue;
        const auto found = pieces.evidenceAt(grid.surfacePoint(i, j, model.levels()[k]));
        QVERIFY(found);
        QCOMPARE(found->cells, static_cast<int>(walk(model, k, tolerance).size()));
      }
    }
  }
}

void TestComponents::aLoneCellCountsLessThanTheGround() {
  EnvironmentModel model(grid);
  for (int i = 0; i < grid.columns(); ++i) {
    for (int j = 20; j < grid.rows(); ++j) scenes::occupy(model, i, j, 4.0);
  }
  scenes::occupy(model, 5, 5, 2.0);
  Components pieces;
  pieces.rebuild(model, 0.1);
  const Evidence ground = at(pieces, 10, 25, 4.0), speck = at(pieces, 5, 5, 2.0);
  QCOMPARE(ground.cells, 40 * 10);
  BW_COMPARE_NEAR(ground.area, 2.0 * 0.5, 1e-9);
  BW_COMPARE_NEAR(ground.extent, std::hypot(2.0, 0.5), 1e-9);
  QCOMPARE(speck.cells, 1);
  BW_COMPARE_NEAR(speck.extent, 0.05 * std::sqrt(2.0), 1e-9);
  // Area 0.0025 m2 of (20 cm)^2: 1 - exp(-1/16), times 0.6 of 2/3.
  const double most = 2.0 / 3.0;
  BW_COMPARE_NEAR(confidenceOf(speck, most), 0.9 * (1 - std::exp(-1.0 / 16)), 1e-6);
  BW_COMPARE_NEAR(confidenceOf(ground, most), 0.9, 1e-6);
}

void TestComponents::aStepInDepthParts() {
  EnvironmentModel model(grid);
  for (int i = 0; i < 10; ++i) scenes::occupy(model, i, 10, i < 5 ? 2.0 : 2.5);
  Components pieces;
  pieces.rebuild(model, 0.1);
  QCOMPARE(at(pieces, 0, 10, 2.0).cells, 5);
  pieces.rebuild(model, 0.6);
  QCOMPARE(at(pieces, 0, 10, 2.0).cells, 10);
  BW_COMPARE_NEAR(at(pieces, 0, 10, 2.0).extent, Eigen::Vector3d(0.5, 0.05, 0.5).norm(), 0.02);
}

void TestComponents::whatIsSmallIsNamed() {
  EnvironmentModel model(grid);
  scenes::occupy(model, 3, 4, 2.0);
  for (int i = 10; i < 14; ++i) scenes::occupy(model, i, 4, 2.0);  // 20 cm x 5 cm
  Components pieces;
  pieces.rebuild(model, 0.1);
  QVERIFY(pieces.doubtful(model, {.smallest = 0.05}).empty());
  QCOMPARE(pieces.doubtful(model, {.smallest = 0.1}), std::vector<std::size_t>{grid.index(3, 4)});
  QCOMPARE(pieces.doubtful(model, {.smallest = 0.21}).size(), std::size_t{5});
}

void TestComponents::whatIsNotLargeMustBeCertain() {
  EnvironmentModel model(grid);
  for (int i = 10; i < 14; ++i) scenes::occupy(model, i, 4, 2.0);  // 20 cm x 5 cm
  for (int i = 10; i < 30; ++i) {                                  // 1 m x 10 cm, and a thin one
    scenes::occupy(model, i, 8, 2.0);
    scenes::occupy(model, i, 9, 2.0);
    scenes::occupy(model, i, 12, 2.0);
  }
  Components pieces;
  pieces.rebuild(model, 0.1);
  const double p = at(pieces, 10, 4, 2.0).probability;
  QVERIFY(pieces.doubtful(model, {.doubtful = 0.4, .certain = p - 0.01}).empty());
  QCOMPARE(pieces.doubtful(model, {.doubtful = 0.4, .certain = p + 0.01}).size(), std::size_t{24});
  QVERIFY(pieces.doubtful(model, {.doubtful = 0.1, .certain = p + 0.01}).empty());
}

/// The tip of a branch: seen for long, but for some cells at its rim. What is certain of it must
/// itself be large enough to count.
void TestComponents::aRimThatComesAndGoesLeavesThePieceCertain() {
  EnvironmentModel model(grid);
  for (int i = 10; i < 16; ++i) model.set(i, 4, i < 13 ? 0.66F : 0.2F, grid.levelOf(2.0));
  Components pieces;
  pieces.rebuild(model, 0.1);
  // Three cells of 5 cm are 0.158 m from corner to corner.
  const auto left = [&](double smallest) {
    return pieces.doubtful(model, {smallest, 0.4, 0.57}).size();
  };
  QCOMPARE(left(0.15), std::size_t{0});
  QCOMPARE(left(0.2), std::size_t{6});
}

/// A slow bird: where it was for long is a few cells of the trail that it leaves behind.
void TestComponents::aTrailIsNoThingForTheFewCellsThatAreCertain() {
  const auto doubtful = [](int certain) {
    EnvironmentModel model(grid);
    for (int i = 0; i < 8; ++i) model.set(10 + i, 4, i < certain ? 0.66F : 0.3F, grid.levelOf(2.0));
    Components pieces;
    pieces.rebuild(model, 0.1);
    return pieces.doubtful(model, {0.1, 0.4, 0.57}).size();
  };
  QCOMPARE(doubtful(3), std::size_t{8});
  QCOMPARE(doubtful(4), std::size_t{0});
}

/// A trunk 0.2 m wide and 9 m away, seen with 700 pixels: rows of cells between its pixels stay
/// empty, and it counts from the first frame all the same. Farther than 4 cm apart is not one.
void TestComponents::cellsFinerThanThePixelsAreOnePiece() {
  const GridGeometry fine({0, 2, 0, 2, 0, 10}, 0.01);
  const auto seen = [&](double apart) {
    EnvironmentModel model(fine);
    for (double y = 0.5; y < 1.5; y += apart) {
      for (double x = 1.0; x < 1.2; x += apart) {
        model.set(fine.columnOf(x), fine.rowOf(y), 0.5F, fine.levelOf(9.0));
      }
    }
    Components pieces;
    pieces.rebuild(model, 0.1);
    return std::pair(pieces, pieces.doubtful(model, {0.0, 0.4, 0.6}).size());
  };
  for (const double apart : {0.01, 9.0 / 700, 0.02, 0.03, 0.04}) {
    const auto [pieces, doubtful] = seen(apart);
    QVERIFY2(doubtful == 0, std::to_string(apart).c_str());
    const auto piece = pieces.evidenceAt(fine.surfacePoint(100, 50, fine.levelOf(9.0)));
    BW_COMPARE_NEAR(piece->area, 0.2, 0.05);
  }
  QCOMPARE(seen(0.04).first.evidenceAt(fine.surfacePoint(100, 50, fine.levelOf(9.0)))->cells,
           5 * 25);
  QCOMPARE(seen(0.06).first.evidenceAt(fine.surfacePoint(100, 50, fine.levelOf(9.0)))->cells, 1);
}

void TestComponents::nothingIsBehindAFreeCell() {
  Components pieces;
  QVERIFY(!pieces.evidenceAt({1, 1, 1}));
  pieces.rebuild(EnvironmentModel(grid), 0.1);
  QVERIFY(!pieces.evidenceAt({1, 1, 1}));
  QVERIFY(!pieces.evidenceAt({-5, 1, 1}));
}

BOOMWATCH_TEST(TestComponents)
#include "test_components.moc"
