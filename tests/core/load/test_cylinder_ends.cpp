#include <QtTest>

#include "load/log/cylinder_ends.h"
#include "support/held_rod.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

CylinderEnds endsOf(const ray_cast::HeldRod& held) {
  return findEnds(held.patch, held.frame, held.cylinder, held.tool, {0.2});
}

/// Metres from the rod's middle, along its axis.
double fromMiddle(const ray_cast::HeldRod& held, double u) {
  const auto direction = held.cylinder.direction();
  const double middle = direction.dot(held.frame.toLocal(held.rod.centre) - held.cylinder.pointA());
  return CylinderEnds::alongAxis(held.cylinder, u) - middle;
}

}  // namespace

class TestCylinderEnds : public QObject {
  Q_OBJECT
 private slots:
  void bothEndsAreWhereTheRodEnds() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const CylinderEnds ends = endsOf(held);
    QVERIFY(ends.seen[0] && ends.seen[1]);
    QVERIFY(ends.filled > 0.95);
    const double first = fromMiddle(held, ends.u[0]), last = fromMiddle(held, ends.u[1]);
    QVERIFY2(std::abs(first + 1.2) < 0.04, qPrintable(QString::number(first)));
    QVERIFY2(std::abs(last - 1.2) < 0.04, qPrintable(QString::number(last)));
  }

  void anEndBehindSomethingIsNotSeen() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::halfCovered(ray_cast::heldLog, 0.15));
    const CylinderEnds ends = endsOf(held);
    QVERIFY(ends.seen[0] && !ends.seen[1]);
    const double last = fromMiddle(held, ends.u[1]), farthest = fromMiddle(held, ends.farthest[1]);
    QVERIFY2(last < 0.7, qPrintable(QString::number(last)));
    QVERIFY2(farthest > 1.15, qPrintable(QString::number(farthest)));
  }

  void aPlaceAlongTheAxisIsThatOfItsNearLine() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const NearLine line = NearLine::fromCylinder(held.cylinder);
    for (const double u : {-0.2, 0.0, 0.1}) {
      const auto axis = held.cylinder.direction();
      const double expected = axis.dot(line.at(u) - held.cylinder.pointA());
      const double along = CylinderEnds::alongAxis(held.cylinder, u);
      QVERIFY2(std::abs(along - expected) < 1e-3, qPrintable(QString::number(along - expected)));
    }
  }
};

BOOMWATCH_TEST(TestCylinderEnds)
#include "test_cylinder_ends.moc"
