#include <QtTest>

#include "load/load_body.h"
#include "support/ray_cast.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double reach = 1.8;

struct Grown {
  DepthPatch patch;
  LoadBody body;
};

Grown grown(const Cloud& cloud, const Vector3d& tool) {
  const Vector3f point = tool.cast<float>();
  Grown result{patchAround(cloud, point, reach, ray_cast::noise, 8.0), {}};
  result.body = growBody(result.patch, point, {reach, 0.2, Bounds{}});
  return result;
}

double besideAxis(const ray_cast::Rod& rod, const Vector3d& p) {
  const Vector3d off = p - rod.centre;
  return (off - rod.axis * rod.axis.dot(off)).norm();
}

}  // namespace

class TestLoadBody : public QObject {
  Q_OBJECT
 private slots:
  void itIsAllThatHangsTogetherWithTheTool() {
    const ray_cast::Rod& rod = ray_cast::heldLog;
    const auto [patch, body] = grown(ray_cast::beforeWall(rod), ray_cast::nearSide(rod));
    QVERIFY(body.fault == LoadFault::None);
    QVERIFY(body.surfaces.empty());
    QCOMPARE(body.points.size(), body.cells.size());
    for (const Vector3d& p : body.points) QVERIFY(besideAxis(rod, p) < rod.radius + 0.03);
    const auto nearer = std::ranges::count_if(patch.q, [](float q) { return q > 1.0F / 6.0F; });
    QVERIFY(static_cast<double>(body.cells.size()) > 0.9 * static_cast<double>(nearer));
    QVERIFY((body.tool - ray_cast::nearSide(rod)).norm() < 0.01);
  }

  void theWallThatItTouchesIsTakenAway() {
    const ray_cast::Rod& rod = ray_cast::heldLog;
    const Vector3d normal = Vector3d(0.0, 0.5, 0.8).normalized();
    const double offset = normal.dot(rod.centre) + 0.8 * rod.radius;
    const Cloud cloud = ray_cast::seen([&](double u, double v) {
      return std::min(rod.depth(u, v), ray_cast::planeDepth(normal, offset, u, v));
    });
    const LoadBody body = grown(cloud, ray_cast::nearSide(rod)).body;
    QVERIFY(body.fault == LoadFault::None);
    QVERIFY(!body.surfaces.empty());
    QVERIFY(std::abs(body.surfaces.front().dot(normal)) > std::cos(0.05));
    for (const Vector3d& p : body.points) QVERIFY(besideAxis(rod, p) < rod.radius + 0.15);
  }

  void aToolInTheAirOrOnAWallHasNone() {
    const Cloud wall = ray_cast::seen([](double, double) { return 4.0; });
    QVERIFY(grown(wall, {0.0, 0.0, 4.0}).body.fault == LoadFault::OnSurface);
    QVERIFY(grown(wall, {0.0, 0.0, 2.0}).body.fault == LoadFault::NothingAtTool);
  }
};

BOOMWATCH_TEST(TestLoadBody)
#include "test_load_body.moc"
