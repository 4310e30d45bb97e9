#include <QtTest>
#include <limits>

#include "collision/observed_share.h"
#include "support/collision_scenes.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector2d;

namespace {

const GridGeometry grid{{-2, 2, -1.5, 1.5, 0, 5}, 0.05};

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double toSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * (b - a)).norm();
}

// To the hull of the projected corners, without making a hull: inside it is inside some triangle
// of corners; outside it, the nearest point lies on a line between two of them.
double toFootprint(const Vector2d& p, const OrientedBox& box) {
  std::vector<Vector2d> c;
  for (const auto& corner : box.corners()) c.push_back(corner.head<2>());
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      best = std::min(best, toSegment(p, c[i], c[j]));
      for (std::size_t k = 0; k < j; ++k) {
        const double a = cross(c[j] - c[i], p - c[i]), b = cross(c[k] - c[j], p - c[j]),
                     d = cross(c[i] - c[k], p - c[k]);
        if ((a > 0 && b > 0 && d > 0) || (a < 0 && b < 0 && d < 0)) return 0;
      }
    }
  }
  return best;
}

// Observed, and not hidden behind a surface nearer to the camera than the box.
bool wasSeen(const EnvironmentModel& model, int i, int j, double boxZ) {
  const GridGeometry& g = model.geometry();
  if (model.state(i, j) != CellState::Occupied) {
    return model.state(i, j) == CellState::ObservedFree;
  }
  return model.levels()[g.index(i, j)] >= g.levelOf(boxZ);
}

// Cell by cell, over the grid as if it went on for `margin` cells beyond its edges.
double cellByCell(const EnvironmentModel& model, const OrientedBox& box, double reach, int margin) {
  const GridGeometry& g = model.geometry();
  double all = 0, seen = 0, nearestZ = g.bounds().zMax;
  for (const auto& corner : box.corners()) nearestZ = std::min(nearestZ, corner.z());
  for (int j = -margin; j < g.rows() + margin; ++j) {
    for (int i = -margin; i < g.columns() + margin; ++i) {
      if (toFootprint({g.xOf(i), g.yOf(j)}, box) > reach) continue;
      ++all;
      if (g.contains(i, j)) seen += wasSeen(model, i, j, nearestZ);
    }
  }
  return seen / all;
}

EnvironmentModel observed(const GridGeometry& geometry, auto&& which) {
  EnvironmentModel model(geometry);
  for (int j = 0; j < geometry.rows(); ++j) {
    for (int i = 0; i < geometry.columns(); ++i) {
      if (which(i, j)) model.set(i, j, boomwatch::observedFloor, 0);
    }
  }
  return model;
}

double shareOf(const EnvironmentModel& model, const OrientedBox& box, double reach) {
  ObservedShare share;
  share.rebuild(model);
  return share.query(box, reach);
}

}  // namespace

class TestObservedShare : public QObject {
  Q_OBJECT

 private slots:
  void whatLiesBehindASurfaceIsNotObserved() {
    EnvironmentModel model(grid);
    for (int j = 0; j < grid.rows(); ++j) {
      for (int i = 0; i < grid.columns(); ++i) {
        // On the left a wall at 2 m, on the right one at 4 m.
        model.set(i, j, 0.6F, grid.levelOf(i < grid.columns() / 2 ? 2.0 : 4.0));
      }
    }
    OrientedBox box{{0, 0, 1}, {0.4, 0.4, 0.4}, Eigen::Matrix3d::Identity()};
    QCOMPARE(shareOf(model, box, 0.5), 1.0);
    box.centre.z() = 3;
    QCOMPARE(shareOf(model, box, 0.5), 0.5);
    box.centre.z() = 4.5;
    QCOMPARE(shareOf(model, box, 0.5), 0.0);
  }

  void equalsCountingCellByCell() {
    scenes::Random random(1);
    const GridGeometry coarse({-2, 2, -1.5, 1.5, 0, 5}, 0.1);
    const auto model =
        observed(coarse, [&](int, int) { return scenes::uniform(random, 0, 1) < 0.6; });
    ObservedShare share;
    share.rebuild(model);
    for (int n = 0; n < 100; ++n) {
      OrientedBox box = scenes::anyLoad(coarse.bounds(), random);
      if (n % 5 == 0) box.size[n % 3] = 0;
      if (n % 7 == 0) box.size.setZero();
      const double reach = n % 4 == 0 ? 0.0 : scenes::uniform(random, 0.1, 1.5);
      const double truth = cellByCell(model, box, reach, 26);
      if (std::isnan(truth)) continue;  // no cell's centre within: tested below
      QVERIFY2(
          std::abs(share.query(box, reach) - truth) < 1e-12,
          qPrintable(
              QString("box %1: %2 instead of %3").arg(n).arg(share.query(box, reach)).arg(truth)));
    }
  }

  void isOneWhereAllWasObservedAndNoughtWhereNothingWas() {
    const OrientedBox box{{0.01, 0.02, 2}, {1, 0.4, 0.6}, rotationFromYawPitchRoll(0.2, 0.3, 0.4)};
    QCOMPARE(shareOf(observed(grid, [](int, int) { return true; }), box, 0.5), 1.0);
    QCOMPARE(shareOf(EnvironmentModel(grid), box, 0.5), 0.0);
  }

  void countsOccupiedAndFreeCellsAlike() {
    EnvironmentModel model(grid);
    const OrientedBox box{grid.surfacePoint(40, 30, 100), {0.06, 0.01, 0.1}};
    model.set(40, 30, 0.6F, 120);
    QCOMPARE(shareOf(model, box, 0.01), 1.0);
    model.set(40, 30, 0.2F, 0);
    QCOMPARE(shareOf(model, box, 0.01), 1.0);
    model.set(40, 30, 0.0F, 0);
    QCOMPARE(shareOf(model, box, 0.01), 0.0);
  }

  void countsWhatLiesOutsideTheBoundsAsUnobserved() {
    const auto model = observed(grid, [](int, int) { return true; });
    const OrientedBox edge{{2, 0, 2}, {1, 0.4, 0.6}};
    BW_COMPARE_NEAR(shareOf(model, edge, 0.3), 0.5, 1e-12);
    const OrientedBox corner{{2, 1.5, 2}, {1, 0.4, 0.6}};
    BW_COMPARE_NEAR(shareOf(model, corner, 0.3), 0.25, 1e-12);
    const OrientedBox outside{{4, 0, 2}, {1, 0.4, 0.6}};
    QCOMPARE(shareOf(model, outside, 0.3), 0.0);
  }

  void countsTheDiscOfAWideReach() {
    const auto model = observed(grid, [](int, int) { return true; });
    const OrientedBox box{{0, 0, 2}, {1, 0.4, 0.6}};
    for (const double reach : {10.0, 200.0, 1e4, 1e6}) {
      const double area = 0.4 + 2.8 * reach + M_PI * reach * reach;
      const double expected = 4.0 * 3.0 / area;
      BW_COMPARE_NEAR(shareOf(model, box, reach) / expected, 1, 1e-3);
    }
    QVERIFY(shareOf(model, box, 1e200) < 1e-12);
  }

  void looksAtTheBoxsOwnCellWhenItCoversNoCentre() {
    EnvironmentModel model(grid);
    const OrientedBox speck{{0.01, 0.01, 2}, {0.001, 0.001, 0.001}};
    QCOMPARE(shareOf(model, speck, 0.001), 0.0);
    model.set(grid.columnOf(0.01), grid.rowOf(0.01), 0.5F, 0);
    QCOMPARE(shareOf(model, speck, 0.001), 1.0);
    const OrientedBox away{{7.01, 0.01, 2}, {0.001, 0.001, 0.001}};
    QCOMPARE(shareOf(model, away, 0.001), 0.0);
  }

  void noticesWhatWasObservedSince() {
    ObservedShare share;
    const OrientedBox box{{0, 0, 2}, {1, 0.4, 0.6}};
    QCOMPARE(share.query(box, 0.3), 0.0);  // before any model
    share.rebuild(EnvironmentModel(grid));
    QCOMPARE(share.query(box, 0.3), 0.0);
    share.rebuild(observed(grid, [](int i, int) { return i < 40; }));
    BW_COMPARE_NEAR(share.query(box, 0.3), 0.5, 1e-12);
    // As many cells as before, but others.
    share.rebuild(observed(grid, [](int i, int) { return i >= 40; }));
    BW_COMPARE_NEAR(share.query(box, 0.3), 0.5, 1e-12);
    share.rebuild(observed(GridGeometry({-1, 1, -1, 1, 0, 5}, 0.1), [](int, int) { return true; }));
    QCOMPARE(share.query(box, 0.3), 1.0);
  }

  void depthIsWatchedBetweenTheBoundsOnly() {
    const Bounds bounds{-2, 2, -2, 2, 1, 5};
    const auto at = [](double z) { return OrientedBox{{0, 0, z}, {1, 0.4, 0.6}}; };
    QCOMPARE(watchedDepth(at(3), 1, bounds), 1.0);
    QCOMPARE(watchedDepth(at(4.2), 1, bounds), 0.5);        // 0.5 m of the metre behind it
    QCOMPARE(watchedDepth(at(4.7), 1, bounds), 0.0);        // it touches the far bound
    QCOMPARE(watchedDepth(at(4.7), 0, bounds), 1.0);        // and nothing more is asked for
    QCOMPARE(watchedDepth(at(4.8), 0, bounds), 0.0);        // it stands out of it
    QCOMPARE(watchedDepth(at(1.8), 1, bounds), 0.5);        // 0.5 m of the metre before it
    QCOMPARE(watchedDepth(at(1.8), 10, bounds), 2.9 / 10);  // the camera is 1.5 m before it
    const OrientedBox standing{
        {0, 0, 4.2}, {1, 0.4, 0.6}, rotationFromYawPitchRoll(M_PI / 2, 0, 0)};
    BW_COMPARE_NEAR(watchedDepth(standing, 1, bounds), 0.3, 1e-9);
    const Bounds fromCamera{-2, 2, -2, 2, 0, 5};
    QCOMPARE(watchedDepth(at(0.4), 1, fromCamera), 1.0);  // nothing is behind the camera
    QCOMPARE(watchedDepth(at(3), std::nan(""), bounds), 0.0);
  }

  void claimsNothingForWhatIsNoBoxOrNoReach() {
    const auto model = observed(grid, [](int, int) { return true; });
    const OrientedBox good{{0, 0, 2}, {1, 0.4, 0.6}};
    QCOMPARE(shareOf(model, good, -1), 1.0);
    for (const double bad : {std::nan(""), HUGE_VAL}) {
      QCOMPARE(shareOf(model, good, bad), 0.0);
      OrientedBox box = good;
      box.size.x() = bad;
      QCOMPARE(shareOf(model, box, 0.3), 0.0);
    }
  }
};

BOOMWATCH_TEST(TestObservedShare)
#include "test_observed_share.moc"
