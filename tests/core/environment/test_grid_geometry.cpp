#include <QtTest>
#include <random>

#include "environment/grid_geometry.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using boomwatch::Bounds;
using boomwatch::GridGeometry;

class TestGrid : public QObject {
  Q_OBJECT

 private slots:
  void sizesAreThoseOfEquation6_data() {
    QTest::addColumn<double>("resolution");
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("rows");
    QTest::newRow("1 cm") << 0.01 << 2000 << 1150;
    QTest::newRow("2 cm") << 0.02 << 1000 << 575;
    QTest::newRow("3 cm") << 0.03 << 666 << 383;
    QTest::newRow("4 cm") << 0.04 << 500 << 287;
    QTest::newRow("larger than the bounds") << 30.0 << 0 << 0;
  }
  void sizesAreThoseOfEquation6() {
    QFETCH(double, resolution);
    const GridGeometry grid(Bounds{}, resolution);
    QTEST(grid.columns(), "columns");
    QTEST(grid.rows(), "rows");
  }

  void depthLevelsAreThoseOfFigure19() {
    const GridGeometry grid(Bounds{-3.2, 3.2, -3.2, 1.6, -0.4, 1.6}, 0.01);
    // Level 175 is 1.37 m from z_min, 0.97 m from the camera; 18 cells are 18 cm.
    BW_COMPARE_NEAR(grid.zOf(175), 0.97, 0.005);
    BW_COMPARE_NEAR(grid.zOf(175) - grid.bounds().zMin, 1.37, 0.005);
    QCOMPARE(grid.levelOf(0.97), std::uint8_t{175});
    BW_COMPARE_NEAR(grid.xOf(118) - grid.xOf(100), 0.18, 1e-12);
  }

  void whatIsMeasuredIsNeverLevelZero() {
    const GridGeometry grid;
    QCOMPARE(grid.levelOf(grid.bounds().zMin), std::uint8_t{1});
    QCOMPARE(grid.levelOf(grid.bounds().zMax), std::uint8_t{255});
    QCOMPARE(grid.levelOf(-1e300), std::uint8_t{1});
    QCOMPARE(grid.levelOf(1e300), std::uint8_t{255});
  }

  void aPointOnAnEdgeBelongsToTheCellThatBeginsThere() {
    for (const double resolution : {0.01, 0.03, 0.04, 0.07, 0.25, 0.3, 1.0}) {
      const GridGeometry grid(Bounds{}, resolution);
      for (int column = 0; column < grid.columns(); ++column) {
        QCOMPARE(grid.columnOf(grid.bounds().xMin + column * resolution), column);
      }
      for (int row = 0; row < grid.rows(); ++row) {
        QCOMPARE(grid.rowOf(grid.bounds().yMin + row * resolution), row);
      }
    }
  }

  void cellsAndLevelsAreTheirDefinition() {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> coordinate(-12.0F, 12.0F);
    for (const double resolution : {0.01, 0.03, 0.04, 0.07}) {
      const GridGeometry grid(Bounds{}, resolution);
      for (int i = 0; i < 100'000; ++i) {
        const double x = coordinate(random);
        QCOMPARE(grid.columnOf(x), static_cast<int>(std::floor((x + 10.0) / resolution + 1e-9)));
        QCOMPARE(grid.rowOf(x), static_cast<int>(std::floor((x + 5.75) / resolution + 1e-9)));
        const long level = std::lround(255.0 * x / 10.0);
        QCOMPARE(static_cast<long>(grid.levelOf(x)), std::clamp(level, 1L, 255L));
      }
    }
  }

  void aCellsCentreIsInTheCell() {
    const GridGeometry grid(Bounds{}, 0.03);
    for (int k = 0; k < grid.columns(); ++k) QCOMPARE(grid.columnOf(grid.xOf(k)), k);
    for (int k = 0; k < grid.rows(); ++k) QCOMPARE(grid.rowOf(grid.yOf(k)), k);
    for (int k = 1; k <= GridGeometry::levels; ++k) QCOMPARE(int(grid.levelOf(grid.zOf(k))), k);
  }

  void anyNumberHasAColumn() {
    const GridGeometry grid;
    for (const double far : {1e30, 1e300, std::numeric_limits<double>::infinity()}) {
      QVERIFY(!grid.contains(grid.columnOf(far), 0));
      QVERIFY(!grid.contains(grid.columnOf(-far), 0));
      QVERIFY(!grid.contains(0, grid.rowOf(far)));
    }
    QVERIFY(!grid.contains(grid.columnOf(std::nan("")), 0));
  }
};

BOOMWATCH_TEST(TestGrid)
#include "test_grid_geometry.moc"
