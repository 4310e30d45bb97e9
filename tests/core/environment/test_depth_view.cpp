#include <QtTest>

#include "environment/depth_view.h"
#include "environment/environment_model.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;
using Eigen::Vector3d;

namespace {

constexpr double size = 0.05, room = 0.25;

}  // namespace

class TestDepthView : public QObject {
  Q_OBJECT
 private slots:
  void looksThroughWhatIsBeforeTheWallOnly();
  void oneRayThatIsStoppedIsEnough();
  void whatIsNotMeasuredIsNotLookedThrough();
  void withoutACameraItSeesNothing();
  void aGhostThatIsLookedThroughIsNotHeld();
  void whatSomethingNearerHidesIsNotForgotten();
};

void TestDepthView::looksThroughWhatIsBeforeTheWallOnly() {
  const auto wall = wallCloud(3.0F);
  const DepthView view(*wall);
  QVERIFY(view.looksThrough({0.3, -0.2, 2.0}, size, room));
  QVERIFY(!view.looksThrough({0.3, -0.2, 2.9}, size, room));  // within the room
  QVERIFY(!view.looksThrough({0.3, -0.2, 3.5}, size, room));
  QVERIFY(!view.looksThrough({30.0, 0.0, 2.0}, size, room));  // out of the picture
  QVERIFY(!view.looksThrough({0.0, 0.0, -2.0}, size, room));
}

void TestDepthView::oneRayThatIsStoppedIsEnough() {
  auto cloud = wallCloud(3.0F);
  // A rod a pixel wide, 1 m away: of a surface of 40 cm, it stops the rays of the right half.
  for (std::size_t row = 0; row < 160; ++row) cloud->points[row * 160 + 84] /= 3.0F;
  const DepthView view(*cloud);
  const double wide = 4.0 * (84 - 79.5) * 2.0 / 80.0;
  QVERIFY(!view.looksThrough({0.0, 0.0, 2.0}, wide, room));
  QVERIFY(view.looksThrough({0.0, 0.0, 2.0}, wide / 4, room));
}

void TestDepthView::whatIsNotMeasuredIsNotLookedThrough() {
  auto cloud = wallCloud(3.0F);
  for (std::size_t row = 70; row < 90; ++row) {
    for (std::size_t column = 70; column < 90; ++column) {
      cloud->points[row * 160 + column] = unmeasuredPoint();
    }
  }
  const DepthView view(*cloud);
  QVERIFY(!view.looksThrough({0.0, 0.0, 2.0}, size, room));
  QVERIFY(view.looksThrough({0.6, 0.0, 2.0}, size, room));
}

void TestDepthView::withoutACameraItSeesNothing() {
  Cloud line = *wallCloud(3.0F);
  line.width *= line.height;
  line.height = 1;
  line.camera.reset();
  QVERIFY(!DepthView(line).looksThrough({0.3, -0.2, 2.0}, size, room));
  QVERIFY(!DepthView(Cloud{}).looksThrough({0.3, -0.2, 2.0}, size, room));
}

/// Something taken out at 1 m stands in the ghost's column along z, but beside it in the picture.
void TestDepthView::aGhostThatIsLookedThroughIsNotHeld() {
  const ModelParameters parameters{.update = ModelUpdate::Thesis};
  const GridGeometry geometry({-2, 2, -2, 2, 0, 5}, size);
  const Vector3d ghost(0.525, 0.025, 2.0);
  const int column = geometry.columnOf(ghost.x()), row = geometry.rowOf(ghost.y());
  const Points seen{ghost.cast<float>()};
  const Points masked{Eigen::Vector3f(0.525F, 0.025F, 1.0F)};
  const auto wall = wallCloud(3.0F);
  const DepthView view(*wall);
  EnvironmentModel held(geometry), released(geometry);
  for (int n = 0; n < 6; ++n) {
    held.update(seen, parameters);
    released.update(seen, parameters);
  }
  held.update({}, parameters, masked);
  released.update({}, parameters, masked, &view);
  QCOMPARE(held.state(column, row), CellState::Occupied);
  QCOMPARE(released.state(column, row), CellState::ObservedFree);
}

/// A tree behind the boom, which stands in other columns of the model than the tree.
void TestDepthView::whatSomethingNearerHidesIsNotForgotten() {
  const ModelParameters parameters;
  const GridGeometry geometry({-2, 2, -2, 2, 0, 5}, size);
  const Vector3d tree(0.525, 0.025, 4.0);
  const int column = geometry.columnOf(tree.x()), row = geometry.rowOf(tree.y());
  const Points seen{tree.cast<float>()};
  const auto boom = wallCloud(3.0F), behind = wallCloud(4.5F);
  const DepthView hidden(*boom), free(*behind);
  QVERIFY(hidden.hides(tree, room));
  QVERIFY(!hidden.hides({0.5, 0.0, 3.1}, room));
  QVERIFY(!hidden.hides({30.0, 0.0, 4.0}, room));  // out of the picture
  QVERIFY(!free.hides(tree, room));
  EnvironmentModel model(geometry), walker(geometry);
  for (int n = 0; n < 20; ++n) model.update(seen, parameters);
  for (int n = 0; n < 10; ++n) walker.update(seen, parameters);
  for (int n = 0; n < 10; ++n) {
    model.update({}, parameters, {}, &hidden);
    walker.update({}, parameters, {}, &hidden);
  }
  QCOMPARE(model.state(column, row), CellState::Occupied);
  QCOMPARE(walker.state(column, row), CellState::ObservedFree);
  for (int n = 0; n < 6; ++n) model.update({}, parameters, {}, &free);
  QCOMPARE(model.state(column, row), CellState::ObservedFree);
}

BOOMWATCH_TEST(TestDepthView)
#include "test_depth_view.moc"
