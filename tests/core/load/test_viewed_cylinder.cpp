#include <QtTest>
#include <numbers>

#include "load/log/viewed_cylinder.h"
#include "support/ray_cast.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

/// Across the view, its axis `distance` away.
ViewedCylinder across(double distance, double radius) {
  ViewedCylinder cylinder;
  cylinder.x << 0.0, 0.0, 1.0 / distance, 1.0 / distance, radius;
  return cylinder;
}

bool isNear(double value, double expected) { return std::abs(value - expected) < 1e-9; }

}  // namespace

class TestViewedCylinder : public QObject {
  Q_OBJECT
 private slots:
  void theFrameLooksAtItAndTurnsBack() {
    const Vector3d point(0.5, -0.4, 4.0), axis = Vector3d(1.0, 0.5, 0.7).normalized();
    const auto frame = CylinderFrame::facing(point, axis, 0.2);
    QVERIFY(frame);
    QVERIFY((frame->view - point.normalized()).norm() < 1e-12);
    QVERIFY(isNear(frame->view.dot(frame->along), 0.0) && isNear(frame->across.dot(axis), 0.0));
    QVERIFY(frame->along.dot(axis) > 0.0);
    const Vector3d p(0.1, 0.7, 5.0);
    QVERIFY((frame->toCamera(frame->toLocal(p)) - p).norm() < 1e-12);
    const auto seen = frame->look(p);
    QVERIFY((frame->toCamera(Vector3d(1.0, seen.u, seen.v) / seen.q) - p).norm() < 1e-12);
  }

  void anAxisThatPointsAtTheCameraHasNoFrame() {
    const Vector3d point(0.0, 0.0, 4.0);
    const auto leaning = [](double angle) { return Vector3d(std::sin(angle), 0, std::cos(angle)); };
    QVERIFY(!CylinderFrame::facing(point, leaning(0.19), 0.2));
    QVERIFY(CylinderFrame::facing(point, leaning(0.21), 0.2));
  }

  void theOutlineIsWhereRaysTouch() {
    const double distance = 5.0, radius = 0.3;
    const CylinderOutline outline(across(distance, radius));
    const double edge = radius / std::sqrt(distance * distance - radius * radius);
    for (const double u : {-0.2, 0.0, 0.3}) {
      QVERIFY(isNear(outline.edge(u, true), edge));
      QVERIFY(isNear(outline.edge(u, false), -edge));
      QVERIFY(isNear(outline.q(u, 0.0), 1.0 / (distance - radius)));
    }
  }

  void itsSurfaceIsWhereRaysMeetIt() {
    const ray_cast::Rod rod{{0.0, 0.0, 5.0}, Vector3d(1.0, 0.0, 0.5).normalized(), 100.0, 0.3};
    ViewedCylinder cylinder = across(5.0, rod.radius);
    // z = 5 + x / 2 along the axis, where x = u z.
    const auto q = [](double u) { return (1.0 - u / 2.0) / 5.0; };
    cylinder.x[2] = q(cylinder.ua), cylinder.x[3] = q(cylinder.ub);
    QVERIFY((cylinder.direction() - Vector3d(0.5, 1.0, 0.0).normalized()).norm() < 1e-9);
    const CylinderOutline outline(cylinder);
    for (const double u : {-0.3, 0.0, 0.25}) {
      for (const double v : {-0.03, 0.0, 0.04}) {
        QVERIFY(isNear(outline.q(u, v), 1.0 / rod.depth(u, v)));
      }
    }
  }

  void theNearLineLiesARadiusBeforeTheAxis() {
    const NearLine line = NearLine::fromCylinder(across(5.0, 0.3));
    QVERIFY((line.at(0.0) - Vector3d(4.7, 0.0, 0.0)).norm() < 1e-9);
    QVERIFY((line.direction() - Vector3d(0.0, 1.0, 0.0)).norm() < 1e-9);
  }

  void aRangeLeavesTheToolOut() {
    const AlongRange range{0.2, -1.0, 2.0};
    QVERIFY(range.holds(0.3) && range.holds(-0.9));
    QVERIFY(!range.holds(0.1) && !range.holds(-0.2) && !range.holds(-1.1) && !range.holds(2.1));
    QVERIFY((AlongRange{0.2}.holds(1e6)));
  }
};

BOOMWATCH_TEST(TestViewedCylinder)
#include "test_viewed_cylinder.moc"
