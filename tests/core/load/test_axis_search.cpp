#include <QtTest>

#include "load/log/axis_search.h"
#include "support/held_rod.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

const AxisLimits limits{0.2, 0.15, 0.5};

/// What is seen of the rod from `first` metres along it.
LoadBody bodyOf(const ray_cast::HeldRod& held, double first) {
  LoadBody body;
  body.tool = held.start().point;
  for (int k = 0; k < held.patch.side * held.patch.side; ++k) {
    if (!(held.patch.q[static_cast<std::size_t>(k)] > 1.0 / 6.0)) continue;  // the wall
    const Vector3d point = held.patch.point(k);
    if (held.rod.axis.dot(point - held.rod.centre) < first) continue;
    body.cells.push_back(k);
    body.points.push_back(point);
  }
  return body;
}

}  // namespace

class TestAxisSearch : public QObject {
  Q_OBJECT
 private slots:
  void theFirstLineLiesAlongTheRod() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const LoadBody body = bodyOf(held, -2.0);
    AxisSearch search(held.patch, body, limits);
    const auto axis = search.next();
    QVERIFY(axis);
    const double sine = axis->direction.cross(held.rod.axis).norm();
    QVERIFY2(sine < 0.1, qPrintable(QString::number(sine)));
    const Vector3d off = axis->point - held.rod.centre;
    const double apart = (off - held.rod.axis * held.rod.axis.dot(off)).norm();
    QVERIFY2(apart < 0.2, qPrintable(QString::number(apart)));
    QVERIFY(std::abs(axis->direction.dot(axis->point - body.tool)) < 1e-6);
  }

  void whatIsLeftOutIsNotFoundAgain() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const LoadBody body = bodyOf(held, -2.0);
    AxisSearch search(held.patch, body, limits);
    QVERIFY(search.next());
    search.leaveOut(held.rod.centre, held.rod.axis, 1.2, 0.15);
    QVERIFY(!search.next());
  }

  void whatEndsAtTheToolAsABoomDoesIsNoLoad() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const LoadBody body = bodyOf(held, -0.1);
    QVERIFY(body.cells.size() > 100);
    AxisSearch search(held.patch, body, limits);
    QVERIFY(!search.next());
  }
};

BOOMWATCH_TEST(TestAxisSearch)
#include "test_axis_search.moc"
