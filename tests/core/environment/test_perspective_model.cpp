#include <QtTest>
#include <limits>

#include "collision/exact_clearance.h"
#include "collision/observed_share.h"
#include "environment/environment_model.h"
#include "support/collision_scenes.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double far = std::numeric_limits<double>::infinity();
const GridGeometry rays({-3, 3, -2, 2, 0, 10}, 0.05, ModelProjection::Perspective);

/// A camera of 400 x 300 pixels with f = 300 px sees a plate of 1 m x 1 m at 2 m before a wall.
std::vector<Vector3f> plateBeforeWall(double wall) {
  std::vector<Vector3f> points;
  for (int row = 0; row < 300; ++row) {
    for (int column = 0; column < 400; ++column) {
      const double u = (column - 199.5) / 300, v = (row - 149.5) / 300;
      const bool plate = std::abs(u) < 0.25 && std::abs(v) < 0.25;
      const double z = plate ? 2.0 : wall;
      points.emplace_back(Vector3d(u * z, v * z, z).cast<float>());
    }
  }
  return points;
}

int holesInView(const EnvironmentModel& model, double u, double v, double plane) {
  const GridGeometry& g = model.geometry();
  int holes = 0;
  for (int j = 0; j < g.rows(); ++j) {
    for (int i = 0; i < g.columns(); ++i) {
      if (std::abs(g.xOf(i)) > u * plane || std::abs(g.yOf(j)) > v * plane) continue;
      holes += model.state(i, j) != CellState::Occupied;
    }
  }
  return holes;
}

EnvironmentModel learnt(const GridGeometry& geometry, const std::vector<Vector3f>& points) {
  EnvironmentModel model(geometry);
  for (int n = 0; n < 5; ++n) model.update(points, ModelParameters{});
  return model;
}

}  // namespace

class TestPerspectiveModel : public QObject {
  Q_OBJECT
 private slots:
  void aPointAndItsCellAgree();
  void aNearThingLeavesNoGapBehindIt();
  void equalsEveryCell();
  void sidewaysBeyondTheBoundsIsLookedThrough();
  void countsWhatWasSeenAlongRays();
};

void TestPerspectiveModel::aPointAndItsCellAgree() {
  scenes::Random random(2);
  QCOMPARE(rays.toPlane(5.0), 1.0);  // the plane lies at half of zMax
  QCOMPARE(rays.cellSize(5.0), 0.05);
  QCOMPARE(rays.cellSize(10.0), 0.1);
  for (int n = 0; n < 2000; ++n) {
    const double z = scenes::uniform(random, 0.2, 10.0);
    const Vector3d p(scenes::uniform(random, -1, 1) * std::min(3.0, z),
                     scenes::uniform(random, -1, 1) * std::min(2.0, z), z);
    const Eigen::Vector2d place = rays.onPlane(p);
    const int i = rays.columnOf(place.x()), j = rays.rowOf(place.y());
    QVERIFY(rays.contains(i, j));
    const Vector3d surface = rays.surfacePoint(i, j, rays.levelOf(z));
    QVERIFY(((surface - p).cwiseAbs() - rays.cellExtent(surface) / 2).maxCoeff() < 1e-3);
  }
}

/// Fig. 17: seen from the camera there is no gap, in columns along z there is one.
void TestPerspectiveModel::aNearThingLeavesNoGapBehindIt() {
  const auto points = plateBeforeWall(6.0);
  // The plate hides 3 m x 3 m of the wall and covers 1 m x 1 m of it.
  const GridGeometry columns({-3, 3, -2, 2, 0, 10}, 0.05);
  const EnvironmentModel parallel = learnt(columns, points);
  const EnvironmentModel perspective = learnt(rays, points);
  QCOMPARE(holesInView(parallel, 0.2, 0.2, 2.0), 0);       // on the plate
  QVERIFY(holesInView(parallel, 0.24, 0.24, 6.0) > 2000);  // beside it, hidden by it
  QCOMPARE(holesInView(perspective, 0.45, 0.3, 5.0), 0);
}

void TestPerspectiveModel::equalsEveryCell() {
  scenes::Random random(4);
  const GridGeometry geometries[] = {
      rays,
      {{-3, 3, -2, 2, 0.5, 10}, 0.11, ModelProjection::Perspective},
      {{0.5, 3, -4, -1, 1, 9}, 0.07, ModelProjection::Perspective},
  };
  for (const GridGeometry& geometry : geometries) {
    QVERIFY(geometry.columns() > 1 && geometry.rows() > 1);
    EnvironmentModel model = scenes::forest(geometry, random, 6, 0.5);
    ExactClearance exact;
    exact.rebuild(model);
    for (int n = 0; n < 500; ++n) {
      const OrientedBox box = scenes::anyLoad(geometry.bounds(), random);
      double best = far;
      for (int j = 0; j < geometry.rows(); ++j) {
        for (int i = 0; i < geometry.columns(); ++i) {
          const int level = model.levels()[geometry.index(i, j)];
          if (level == 0) continue;
          const Vector3d p = geometry.surfacePoint(i, j, level);
          best = std::min(best, (p - box.nearestTo(p)).norm());
        }
      }
      BW_COMPARE_NEAR(exact.query(box, far).nearest->distance, best, 1e-12);
    }
  }
}

void TestPerspectiveModel::sidewaysBeyondTheBoundsIsLookedThrough() {
  const GridGeometry geometry({-1, 1, -1, 1, 0, 10}, 0.05, ModelProjection::Perspective);
  const std::vector<Vector3f> points{{3.0F, 0.0F, 6.0F}};  // leaves the bounds at z = 2
  EnvironmentModel model(geometry);
  model.update(points, ModelParameters{});
  const Eigen::Vector2d place = geometry.onPlane({3.0, 0.0, 6.0});
  const int i = geometry.columnOf(place.x()), j = geometry.rowOf(place.y());
  QVERIFY(geometry.contains(i, j));
  QVERIFY(model.state(i, j) == CellState::ObservedFree);
}

void TestPerspectiveModel::countsWhatWasSeenAlongRays() {
  ObservedShare share;
  share.rebuild(learnt(rays, plateBeforeWall(6.0)));
  // Before the wall, beside the plate's shadow: all was seen. Behind the plate: nothing.
  QCOMPARE(share.query({{1.8, 0.0, 4.0}, {0.2, 0.2, 0.2}}, 0.2), 1.0);
  QCOMPARE(share.query({{0.0, 0.0, 4.0}, {0.2, 0.2, 0.2}}, 0.2), 0.0);
  QCOMPARE(share.query({{0.0, 0.0, -1.0}, {0.2, 0.2, 0.2}}, 0.2), 0.0);
}

BOOMWATCH_TEST(TestPerspectiveModel)
#include "test_perspective_model.moc"
