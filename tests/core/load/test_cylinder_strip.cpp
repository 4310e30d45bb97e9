#include <QtTest>
#include <algorithm>

#include "load/log/cylinder_strip.h"
#include "support/held_rod.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

const CylinderStrip::Limits limits{0.4, 0.03, 0.5, {0.2}};

std::optional<CylinderStrip> stripOf(const ray_cast::HeldRod& held) {
  return cutStrip(held.patch, held.frame, NearLine::fromAxis(held.frame, held.start()), held.tool,
                  limits);
}

}  // namespace

class TestCylinderStrip : public QObject {
  Q_OBJECT
 private slots:
  void surfaceAndEdgesAreThoseOfTheCylinder() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const auto strip = stripOf(held);
    QVERIFY(strip);
    QVERIFY(strip->outlined > 0.9);
    QVERIFY(strip->surface.size() > 100 && strip->edges.size() > 40);
    const CylinderOutline outline(held.cylinder);
    // The flat end that faces the camera is seen as well, and is none of the round surface.
    const auto onIt = std::ranges::count_if(strip->surface, [&](const auto& s) {
      return std::abs(1.0 / outline.q(s.u, s.v) - 1.0 / s.q) < 0.03;
    });
    const double share = static_cast<double>(onIt) / static_cast<double>(strip->surface.size());
    QVERIFY2(share > 0.95, qPrintable(QString::number(share)));
    double pixels = 0.0;
    for (const CylinderStrip::Edge& e : strip->edges) {
      pixels += std::abs(outline.edge(e.u, e.upper) - e.v) * 600.0;
    }
    pixels /= static_cast<double>(strip->edges.size());
    QVERIFY2(pixels < 1.0, qPrintable(QString::number(pixels)));
    const double radius = strip->guess.radius();
    QVERIFY2(std::abs(radius - 0.15) < 0.01, qPrintable(QString::number(radius)));
  }

  void theToolIsLeftOut() {
    const ray_cast::HeldRod held(ray_cast::heldLog, ray_cast::beforeWall(ray_cast::heldLog));
    const NearLine line = NearLine::fromAxis(held.frame, held.start());
    const auto strip = stripOf(held);
    QVERIFY(strip);
    for (const CylinderStrip::Edge& e : strip->edges) {
      const double along = line.direction().dot(line.at(e.u) - held.tool);
      QVERIFY2(std::abs(along) > 0.19, qPrintable(QString::number(along)));
    }
  }

  void aWallHasNoOutline() {
    const ray_cast::HeldRod held(ray_cast::heldLog,
                                 ray_cast::seen([](double, double) { return 3.85; }));
    QVERIFY(!stripOf(held));
  }
};

BOOMWATCH_TEST(TestCylinderStrip)
#include "test_cylinder_strip.moc"
