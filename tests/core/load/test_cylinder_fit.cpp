#include <QtTest>

#include "load/log/cylinder_fit.h"
#include "support/held_rod.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

const CylinderLimits limits{0.2, 0.03, 0.5};

/// Begins 3 cm and 3 degrees beside the rod.
CylinderFit fitOf(const ray_cast::HeldRod& held) {
  LoadAxis start = held.start();
  const Vector3d tool = start.point;
  start.point += Vector3d(0.0, 0.03, 0.0);
  start.direction = (start.direction + Vector3d(0.0, 0.05, 0.0)).normalized();
  return fitCylinder(held.patch, tool, start, limits);
}

}  // namespace

class TestCylinderFit : public QObject {
  Q_OBJECT
 private slots:
  void aRodIsFittedFromEndToEnd() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const CylinderFit fit = fitOf(held);
    QVERIFY(fit.fault == LoadFault::None);
    QVERIFY(fit.endSeen[0] && fit.endSeen[1]);
    QVERIFY2(std::abs(fit.radius - 0.15) < 0.01, qPrintable(QString::number(fit.radius)));
    QVERIFY2(std::abs(fit.length - 2.4) < 0.06, qPrintable(QString::number(fit.length)));
    const double apart = (fit.centre - held.rod.centre).norm();
    QVERIFY2(apart < 0.04, qPrintable(QString::number(apart)));
    const double sine = fit.axis.cross(held.rod.axis).norm();
    QVERIFY2(sine < 0.02, qPrintable(QString::number(sine)));
    // The tool holds it in the middle.
    QVERIFY(std::abs(fit.arm[0] - 1.0) < 0.06 && std::abs(fit.arm[1] - 1.0) < 0.06);
  }

  void ofACoveredEndItSaysHowFarItMayGoOn() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::halfCovered(ray_cast::heldLog, 0.2));
    const CylinderFit fit = fitOf(held);
    QVERIFY(fit.fault == LoadFault::None);
    const std::size_t covered = fit.axis.x() > 0.0 ? 1 : 0;
    QVERIFY(!fit.endSeen[covered] && fit.endSeen[1 - covered]);
    QVERIFY2(fit.length + fit.hidden[covered] > 2.3, qPrintable(QString::number(fit.length)));
  }

  void whatPointsAtTheCameraOrIsNotThereIsRefused() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const Vector3d tool = held.start().point;
    const CylinderFit endOn = fitCylinder(held.patch, tool, {tool, tool.normalized()}, limits);
    QVERIFY(endOn.fault == LoadFault::EndOn);
    const ray_cast::HeldRod wall(ray_cast::heldLog,
                                 ray_cast::seen([](double, double) { return 3.85; }));
    QVERIFY(fitOf(wall).fault == LoadFault::FewPoints);
  }
};

BOOMWATCH_TEST(TestCylinderFit)
#include "test_cylinder_fit.moc"
