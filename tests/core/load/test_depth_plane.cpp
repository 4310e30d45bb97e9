#include <QtTest>
#include <numeric>

#include "load/depth_plane.h"
#include "support/ray_cast.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

/// Of a plane through (0, 0, 4) that leans 30 degrees, as q = n . (u, v, 1).
const Vector3d normal = Vector3d(0.0, std::sin(0.5236), std::cos(0.5236));
const Vector3d truth = normal / (4.0 * normal.z());

std::vector<int> measuredCells(const DepthPatch& patch) {
  std::vector<int> cells;
  for (int k = 0; k < patch.side * patch.side; ++k) {
    if (!std::isnan(patch.q[static_cast<std::size_t>(k)])) cells.push_back(k);
  }
  return cells;
}

DepthPatch patchOf(const Cloud& cloud) {
  return patchAround(cloud, {0.0F, 0.0F, 4.0F}, 1.2, ray_cast::noise, 8.0);
}

}  // namespace

class TestDepthPlane : public QObject {
  Q_OBJECT
 private slots:
  void itIsTheOneThatMostCellsLieOn() {
    // A third of the picture is nearer, and not flat.
    const DepthPatch patch = patchOf(ray_cast::seen([](double u, double v) {
      const double plane = ray_cast::planeDepth(normal, 4.0 * normal.z(), u, v);
      return u > 0.1 ? plane - 0.5 - 3.0 * u * u : plane;
    }));
    const std::vector<int> cells = measuredCells(patch);
    const auto plane = dominantPlane(patch, cells, 0.01);
    QVERIFY(plane);
    QVERIFY2((plane->n - truth).norm() < 1e-3,
             qPrintable(QString::number((plane->n - truth).norm())));
    const auto held =
        std::ranges::count_if(cells, [&](int cell) { return plane->holds(patch, cell, 0.01); });
    const double share = static_cast<double>(held) / static_cast<double>(cells.size());
    QVERIFY2(std::abs(share - 2.0 / 3.0) < 0.03, qPrintable(QString::number(share)));
  }

  void aCellIsHeldWithinTheThickness() {
    const DepthPatch patch = patchOf(ray_cast::seen([](double, double) { return 4.0; }));
    const int cell = patch.indexOf(0.0, 0.0);
    QVERIFY((DepthPlane{{0.0, 0.0, 1.0 / 4.009}}.holds(patch, cell, 0.01)));
    QVERIFY(!(DepthPlane{{0.0, 0.0, 1.0 / 4.02}}.holds(patch, cell, 0.01)));
  }

  void noPlaneGoesThroughOneCell() {
    const DepthPatch patch = patchOf(ray_cast::seen([](double, double) { return 4.0; }));
    QVERIFY(!dominantPlane(patch, {patch.indexOf(0.0, 0.0)}, 0.01));
  }
};

BOOMWATCH_TEST(TestDepthPlane)
#include "test_depth_plane.moc"
