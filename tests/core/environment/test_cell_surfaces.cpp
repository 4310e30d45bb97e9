#include <QtTest>
#include <map>

#include "environment/cell_surfaces.h"
#include "environment/grid_geometry.h"
#include "support/compare_near.h"
#include "support/enumerators.h"
#include "support/test_registry.h"

using boomwatch::Bounds;
using boomwatch::CellSurfaces;
using boomwatch::every;
using boomwatch::GridGeometry;
using boomwatch::ModelProjection;
using boomwatch::Points;
using Eigen::Vector3f;

namespace {

constexpr double side = 0.04;
const GridGeometry grid(Bounds{}, side);

/// In cell (250, 140), at a depth.
Vector3f at(float z) { return {float(grid.xOf(250)), float(grid.yOf(140)), z}; }

/// A plane through (0, 0, 5) that comes nearer by `slope` metres a metre to the right, as voxels.
Points slantedPlane(float slope) {
  Points points;
  for (float x = -1.0F; x < 1.0F; x += 0.005F) {
    for (float y = -1.0F; y < 1.0F; y += 0.02F) points.emplace_back(x, y, 5.0F - slope * x);
  }
  return points;
}

/// Mean over the cells of how far before the plane they are, along its normal.
double meanBefore(const Points& cells, float slope, const GridGeometry& geometry) {
  double sum = 0.0;
  for (const Vector3f& p : cells) {
    const Eigen::Vector2d q = geometry.onPlane(p.cast<double>());
    const int column = geometry.columnOf(q.x());
    const double x = geometry.xOf(column) / geometry.toPlane(double(p.z()));
    const double before = 5.0 - double(slope) * x - double(p.z());
    sum += before / std::hypot(1.0, double(slope));
  }
  return sum / static_cast<double>(cells.size());
}

/// What Eq. 10 alone makes of it: the nearest point of every cell.
Points nearestOf(const Points& points, const GridGeometry& geometry) {
  std::map<std::size_t, Vector3f> cells;
  for (const Vector3f& p : points) {
    const Eigen::Vector2d q = geometry.onPlane(p.cast<double>());
    const auto [cell, isNew] =
        cells.emplace(geometry.index(geometry.columnOf(q.x()), geometry.rowOf(q.y())), p);
    if (!isNew && p.z() < cell->second.z()) cell->second = p;
  }
  Points nearest;
  for (const auto& [index, p] : cells) nearest.push_back(p);
  return nearest;
}

}  // namespace

class TestCellSurfaces : public QObject {
  Q_OBJECT

 private slots:
  void aSlantedSurfaceStandsWhereItIs_data() {
    QTest::addColumn<float>("slope");
    QTest::addColumn<ModelProjection>("projection");
    for (const float slope : {0.0F, 0.3F, 1.0F, 2.0F}) {
      QTest::addRow("slope %g", double(slope)) << slope << ModelProjection::Parallel;
      QTest::addRow("slope %g, perspective", double(slope))
          << slope << ModelProjection::Perspective;
    }
  }
  void aSlantedSurfaceStandsWhereItIs() {
    QFETCH(float, slope);
    QFETCH(ModelProjection, projection);
    const GridGeometry geometry(Bounds{}, side, projection);
    const Points plane = slantedPlane(slope);
    const Points cells = CellSurfaces().extract(plane, geometry);
    const Points nearest = nearestOf(plane, geometry);
    QCOMPARE(cells.size(), nearest.size());
    BW_COMPARE_NEAR(meanBefore(cells, slope, geometry), 0.0, 0.002);
    // The reason for all this.
    const double half = side / 2 * double(slope) / std::hypot(1.0, double(slope));
    QVERIFY(meanBefore(nearest, slope, geometry) > 0.5 * half - 0.001);
  }

  void aCellIsAtMostOneCellBehindItsNearestPoint() {
    for (float behind = 0.0F; behind < 0.5F; behind += 0.005F) {
      Points points{at(3.0F)};
      for (int k = 0; k < 100; ++k) points.push_back(at(3.0F + behind));
      const Points cells = CellSurfaces().extract(points, grid);
      QCOMPARE(cells.size(), std::size_t{1});
      QVERIFY(cells[0].z() >= 3.0F && cells[0].z() <= 3.0F + float(side) * 1.001F);
      if (behind > 2.001F * float(side)) QCOMPARE(cells[0].z(), 3.0F);  // another surface
    }
  }

  void theOrderOfPointsDoesNotMatterAndNothingIsKept() {
    CellSurfaces surfaces;
    Points points{at(3.00F), at(3.02F), at(3.07F), at(9.0F)};
    const float mean = 3.03F;
    const auto isNearer = [](const Vector3f& a, const Vector3f& b) { return a.z() < b.z(); };
    do {
      const Points cells = surfaces.extract(points, grid);
      QCOMPARE(cells.size(), std::size_t{1});
      BW_COMPARE_NEAR(cells[0].z(), mean, 1e-5F);
    } while (std::next_permutation(points.begin(), points.end(), isNearer));
    QCOMPARE(surfaces.extract(Points{at(7.0F)}, grid)[0].z(), 7.0F);
    QVERIFY(surfaces.extract({}, grid).empty());
    QVERIFY(surfaces.extract(Points{at(1.0F)}, GridGeometry(Bounds{}, 100.0)).empty());
  }

  void aPointStaysInItsCellAndInTheBounds() {
    const Bounds bounds{-1.0, 1.0, -1.0, 1.0, 1.0, 5.0};
    for (const auto projection : every<ModelProjection>()) {
      const GridGeometry geometry(bounds, side, projection);
      Points points;
      for (float x = -0.999F; x < 1.0F; x += 0.011F) {
        for (float z = 1.0F; z < 5.0F; z += 0.3F) {
          points.insert(points.end(), {{x, 0.3F, z}, {x, 0.3F, std::min(5.0F, z + 0.03F)}});
        }
      }
      const Points cells = CellSurfaces().extract(points, geometry);
      const Points nearest = nearestOf(points, geometry);
      QCOMPARE(cells.size(), nearest.size());
      // In each cell one, where there was one: none has left its own.
      QCOMPARE(nearestOf(cells, geometry).size(), nearest.size());
      for (const Vector3f& p : cells) QVERIFY(bounds.contains(p));
    }
  }
};

BOOMWATCH_TEST(TestCellSurfaces)
#include "test_cell_surfaces.moc"
