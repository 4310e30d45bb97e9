#include <Eigen/Geometry>
#include <QtTest>
#include <cmath>
#include <numbers>
#include <random>

#include "environment/grid_geometry.h"
#include "simulation/demo_source.h"
#include "simulation/scene.h"
#include "simulation/scene_view.h"
#include "support/camera_check.h"
#include "support/compare_near.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

constexpr std::chrono::milliseconds patience{100};

OrientedBox randomLoad(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0), size(0.1, 2.0);
  const auto angle = [&] { return unit(random) * std::numbers::pi; };
  return {{3.0 * unit(random), 1.5 * unit(random), 5.0 + 3.0 * unit(random)},
          {size(random), size(random), size(random)},
          rotationFromYawPitchRoll(angle(), angle(), angle())};
}

Vector3d nearestOf(const Cylinder& c, const Vector3d& p) {
  const double along = c.axis.dot(p - c.centre);
  const Vector3d across = p - c.centre - along * c.axis;
  const double radius = across.norm();
  return c.centre + std::clamp(along, -c.length / 2, c.length / 2) * c.axis +
         (radius > c.radius ? Vector3d(across * (c.radius / radius)) : across);
}
Vector3d nearestOf(const OrientedBox& box, const Vector3d& p) { return box.nearestTo(p); }

/// Goes to and fro between two convex bodies, which ends at the shortest line between them.
template <class Solid>
double refined(const OrientedBox& load, const Solid& solid, Vector3d p) {
  for (int k = 0; k < 20000; ++k) {
    const Vector3d next = nearestOf(solid, load.nearestTo(p));
    if ((next - p).norm() < 1e-9) break;
    p = next;
  }
  return (p - load.nearestTo(p)).norm();
}

/// Points all over a cylinder, 2 cm apart.
std::vector<Vector3d> sampled(const Cylinder& c) {
  std::vector<Vector3d> points;
  const Vector3d side = c.axis.unitOrthogonal();
  const Vector3d other = c.axis.cross(side);
  for (double along = -c.length / 2; along <= c.length / 2 + 1e-9; along += 0.02) {
    for (int k = 0; k < 48; ++k) {
      const double a = k * std::numbers::pi / 24.0;
      const Vector3d out = std::cos(a) * side + std::sin(a) * other;
      points.push_back(c.centre + along * c.axis + c.radius * out);
    }
  }
  return points;
}

std::vector<Vector3d> sampled(const OrientedBox& box) {
  std::vector<Vector3d> points;
  const Eigen::Array3i n = (box.size.array() / 0.05).ceil().cast<int>() + 1;
  for (int i = 0; i <= n.x(); ++i) {
    for (int j = 0; j <= n.y(); ++j) {
      for (int k = 0; k <= n.z(); ++k) {
        const Eigen::Array3d share = Eigen::Array3d(i, j, k) / n.cast<double>() - 0.5;
        points.push_back(box.centre + box.rotation * (share * box.size.array()).matrix());
      }
    }
  }
  return points;
}

template <class Solid>
double bruteForce(const OrientedBox& load, const Solid& solid) {
  double best = std::numeric_limits<double>::infinity();
  Vector3d start = Vector3d::Zero();
  for (const Vector3d& p : sampled(solid)) {
    const double d = (p - load.nearestTo(p)).norm();
    if (d < best) {
      best = d;
      start = p;
    }
  }
  return refined(load, solid, start);
}

/// The clearance that the thesis's model can know (docs/method.md section 6): the nearest level a
/// cell.
double modelDistance(const Cloud& cloud, const OrientedBox& load, double resolution) {
  const GridGeometry grid(Bounds{}, resolution);
  std::vector<int> levels(grid.cellCount(), 256);
  for (const auto& point : cloud.points) {
    if (!isMeasured(point) || !grid.bounds().contains(point)) continue;
    const int column = grid.columnOf(double(point.x())), row = grid.rowOf(double(point.y()));
    if (!grid.contains(column, row)) continue;
    int& level = levels[grid.index(column, row)];
    level = std::min(level, int(grid.levelOf(double(point.z()))));
  }
  double best = std::numeric_limits<double>::infinity();
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const int level = levels[grid.index(column, row)];
      if (level > 255) continue;
      const Vector3d p = grid.surfacePoint(column, row, level);
      best = std::min(best, (p - load.nearestTo(p)).norm());
    }
  }
  return best;
}

/// How far a point is from the nearest solid.
double outside(const Scene& scene, const Vector3d& p) {
  double nearest = std::max(0.0, scene.ground.heightOf(p));
  for (const auto& c : scene.cylinders) nearest = std::min(nearest, (nearestOf(c, p) - p).norm());
  for (const auto& b : scene.boxes) nearest = std::min(nearest, (nearestOf(b, p) - p).norm());
  return nearest;
}

bool equalPictures(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

Scene sceneNamed(const QString& name) {
  if (name == "floor") return floorScene();
  return name == "wall" ? wallScene() : cylindersScene();
}

void addSceneRows() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"floor", "cylinders", "wall"}) QTest::newRow(name) << name;
}

}  // namespace

class TestDemoSource : public QObject {
  Q_OBJECT

  /// 300 random loads against the solids that `solidOf` gives.
  template <class SolidOf>
  static void distancesAreThoseOfBruteForce(unsigned seed, SolidOf&& solidOf) {
    std::mt19937 random(seed);
    int apart = 0;
    for (int k = 0; k < 300; ++k) {
      const OrientedBox load = randomLoad(random);
      const auto solid = solidOf(random, k);
      const double wanted = bruteForce(load, solid);
      const double got = distance(load, solid);
      QVERIFY2(
          std::abs(got - wanted) < 1e-3,
          qPrintable(QString("%1: %2, not %3").arg(k).arg(got, 0, 'g', 9).arg(wanted, 0, 'g', 9)));
      apart += wanted > 0.01;
    }
    QVERIFY(apart > 100 && apart < 290);
  }

 private slots:
  void distancesToCylindersAreThoseOfBruteForce() {
    distancesAreThoseOfBruteForce(3, [](std::mt19937&, int k) -> Cylinder {
      return {{0.3, 0.2, 5.0}, Vector3d(k % 3, 3, k % 2).normalized(), 3.0, 0.15};
    });
  }

  void distancesToBoxesAreThoseOfBruteForce() {
    distancesAreThoseOfBruteForce(4, [](std::mt19937& random, int) { return randomLoad(random); });
  }

  // Coordinates in steps of a quarter make bodies that touch, are parallel, or are flat.
  void tiesAndFlatBodiesAreExact() {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> step(-8, 8);
    const auto q = [&] { return step(random) / 4.0; };
    const auto randomBox = [&]() -> OrientedBox {
      return {{q(), q(), q()}, Vector3d(q(), q(), q()).cwiseAbs(), Eigen::Matrix3d::Identity()};
    };
    const Cylinder cylinder{Vector3d::Zero(), Vector3d::UnitY(), 2.0, 0.5};
    for (int k = 0; k < 20000; ++k) {
      const OrientedBox a = randomBox(), b = randomBox();
      const Vector3d gap = ((a.centre - b.centre).cwiseAbs() - (a.size + b.size) / 2).cwiseMax(0.0);
      BW_COMPARE_NEAR(distance(a, b), gap.norm(), 2e-6);
      const OrientedBox point{a.centre, Vector3d::Zero(), Eigen::Matrix3d::Identity()};
      BW_COMPARE_NEAR(distance(point, cylinder), cylinder.distanceTo(a.centre), 2e-6);
    }
  }

  void theDistanceToTheGroundIsThatOfTheLowestCorner() {
    const Ground ground{Vector3d(0, -1, 0), 2.0};
    QCOMPARE(distance(lyingLoad({0, 0, 5}), ground), 1.85);
    QCOMPARE(distance(lyingLoad({0, 1.9, 5}), ground), 0.0);
    QCOMPARE(distance(lyingLoad({0, 9, 5}), ground), 0.0);
  }

  void raysEndOnTheSurfacesTheyMeet_data() { addSceneRows(); }
  void raysEndOnTheSurfacesTheyMeet() {
    QFETCH(QString, name);
    const Scene scene = sceneNamed(name);
    const SceneView view = lookAt(scene, PinholeCamera::centred(192, 144, 150.0));
    std::size_t measured = 0;
    for (int v = 0; v < 144; ++v) {
      for (int u = 0; u < 192; ++u) {
        const auto& found = view.cloud->at(u, v);
        const Vector3d ray = view.cloud->camera->ray(u, v);
        if (isMeasured(found)) {
          ++measured;
          const Vector3d p = found.cast<double>();
          QVERIFY(p.cross(ray).norm() < 1e-4);
          QVERIFY2(outside(scene, p) < 1e-4, qPrintable(QString("%1, %2").arg(u).arg(v)));
        }
        // Nothing stands before the surface that was found.
        const double end = isMeasured(found) ? double(found.z()) : SceneView::farthest;
        for (double z = 0.1; z < end - 0.01; z += 0.1) {
          if (outside(scene, z * ray) <= 0.0) QFAIL("a ray passes through a solid");
        }
      }
    }
    QVERIFY(measured > 192 * 144 / 3);
    QVERIFY(missOfCamera(*view.cloud) < 1e-3);
  }

  void figure22HoldsForTheGeometry() {
    const Scene scene = cylindersScene();
    BW_COMPARE_NEAR(distance(cylindersInFront(), scene), 0.6, 1e-5);
    QCOMPARE(distance(cylindersInside(), scene), 0.0);
    BW_COMPARE_NEAR(distance(cylindersPast(), scene), 1.9, 1e-5);
    BW_COMPARE_NEAR(distance(cylindersPast(), scene.ground), 1.9, 1e-9);
    for (const auto& cylinder : scene.cylinders) QVERIFY(distance(cylindersPast(), cylinder) > 2.0);
    // One line along z, as in the thesis.
    const Vector3d way = cylindersPast().centre - cylindersInFront().centre;
    QVERIFY(way.z() > 0.0 && way.head<2>().isZero());
  }

  void figure22HoldsForWhatTheCameraSees() {
    const auto cloud = lookAt(cylindersScene()).cloud;
    BW_COMPARE_NEAR(distanceToSeen(cylindersInFront(), *cloud).value(), 0.6, 0.005);
    QCOMPARE(distanceToSeen(cylindersInside(), *cloud).value(), 0.0);
    BW_COMPARE_NEAR(distanceToSeen(cylindersPast(), *cloud).value(), 1.9, 0.005);
  }

  void figure22HoldsForTheModel_data() {
    QTest::addColumn<double>("resolution");
    for (const double r : {0.01, 0.02, 0.04}) QTest::addRow("%g", r) << r;
  }
  void figure22HoldsForTheModel() {
    QFETCH(double, resolution);
    const auto cloud = lookAt(cylindersScene()).cloud;
    const double level = 10.0 / 255.0;
    const double allowed = resolution + level;
    BW_COMPARE_NEAR(modelDistance(*cloud, cylindersInFront(), resolution), 0.6, allowed);
    QCOMPARE(modelDistance(*cloud, cylindersInside(), resolution), 0.0);
    BW_COMPARE_NEAR(modelDistance(*cloud, cylindersPast(), resolution), 1.9, allowed);
  }

  void ofTheWallOnlyTheGableIsSeen() {
    const Scene scene = wallScene();
    const auto cloud = lookAt(scene).cloud;
    std::size_t gable = 0;
    for (const auto& p : cloud->points) {
      if (!isMeasured(p) || std::abs(scene.ground.heightOf(p.cast<double>())) < 1e-4) continue;
      BW_COMPARE_NEAR(p.z(), 5.0F, 1e-4F);
      BW_COMPARE_NEAR(p.x(), 0.0, 0.1001F);
      ++gable;
    }
    QVERIFY(gable > 5000);
    QCOMPARE(distance(wallInside(), scene), 0.0);
    BW_COMPARE_NEAR(distanceToSeen(wallInside(), *cloud).value(), 0.7, 0.005);
    BW_COMPARE_NEAR(modelDistance(*cloud, wallInside(), 0.04), 0.7, 0.08);
  }

  void nothingSeenIsNoDistance() {
    const Cloud cloud{1, 1, {unmeasuredPoint()}, {}, {}};
    QVERIFY(!distanceToSeen(wallInside(), cloud));
  }

  void framesCarryEverythingAndTheTruth_data() { addSceneRows(); }
  void framesCarryEverythingAndTheTruth() {
    QFETCH(QString, name);
    const Scene scene = sceneNamed(name);
    const auto source = openDemoSource(name.toStdString(), "demo:" + name.toStdString());
    QCOMPARE(QString::fromStdString(source->info().address), "demo:" + name);
    QCOMPARE(source->info().frameCount, std::optional<std::size_t>(600));
    QVERIFY(!source->info().live);
    for (std::size_t k = 0; k < 600; k += 50) {
      QVERIFY(source->seek(k));
      const ReadResult read = source->next(patience);
      QVERIFY(read.status == ReadResult::Status::Ok);
      const Frame& frame = *read.frame;
      QCOMPARE(frame.sequence, k);
      QCOMPARE(frame.stamp, double(k) / 20.0);
      QVERIFY(frame.cloud->organised());
      QCOMPARE(frame.cloud->size(), frame.left.total());
      QVERIFY(frame.right.empty());
      QCOMPARE(frame.trueDistance.value(), distance(frame.load.value(), scene));
    }
  }

  void theLoadMovesAlongOneAxisAtATimeTouchesAndComesBack_data() { addSceneRows(); }
  void theLoadMovesAlongOneAxisAtATimeTouchesAndComesBack() {
    QFETCH(QString, name);
    const auto source = openDemoSource(name.toStdString(), "");
    std::vector<Vector3d> centres;
    int touching = 0;
    // Every fifth frame: to draw all of them takes minutes under ThreadSanitizer.
    for (std::size_t k = 0; k < 600; k += 5) {
      QVERIFY(source->seek(k));
      const FramePtr frame = source->next(patience).frame;
      centres.push_back(frame->load.value().centre);
      touching += frame->trueDistance == 0.0;
    }
    QVERIFY(touching > 1 && touching < 60);
    for (std::size_t k = 0; k < centres.size(); ++k) {
      const Vector3d step = centres[(k + 1) % centres.size()] - centres[k];
      const int axis = int(k / 40);
      for (int other = 0; other < 3; ++other) {
        if (other != axis) BW_COMPARE_NEAR(step[other], 0.0, 1e-9);
      }
      QVERIFY(step.norm() < 0.5);
    }
    for (int axis = 0; axis < 3; ++axis) {
      double most = 0.0;
      for (const Vector3d& c : centres) most = std::max(most, std::abs(c[axis] - centres[0][axis]));
      QVERIFY(most > 0.5);
    }
  }

  void seekingGivesTheFrameThatSteppingGives() {
    const auto stepped = openDemoSource("cylinders", "");
    const auto sought = openDemoSource("cylinders", "");
    for (std::size_t k = 0; k < 12; ++k) {
      const FramePtr wanted = stepped->next(patience).frame;
      if (k % 4 != 3) continue;
      QVERIFY(sought->seek(k));
      const FramePtr got = sought->next(patience).frame;
      QCOMPARE(got->sequence, wanted->sequence);
      QVERIFY(equalPictures(got->left, wanted->left));
      QVERIFY(got->load->centre == wanted->load->centre);
      QVERIFY(std::memcmp(got->cloud->points.data(), wanted->cloud->points.data(),
                          got->cloud->size() * sizeof(Eigen::Vector3f)) == 0);
    }
  }

  void noTwoPicturesInARowAreEqualAndTheCloudIsShared() {
    const auto source = openDemoSource("floor", "");
    FramePtr before = source->next(patience).frame;
    for (int k = 0; k < 60; ++k) {
      const FramePtr frame = source->next(patience).frame;
      QVERIFY(!equalPictures(frame->left, before->left));
      QCOMPARE(frame->cloud.get(), before->cloud.get());
      before = frame;
    }
  }

  void theLoadIsInThePictureWhereNothingStandsBeforeIt() {
    const SceneView view = lookAt(cylindersScene());
    const auto changed = [&](const OrientedBox& load) {
      cv::Mat difference;
      cv::absdiff(pictureWithLoad(view, load, 1), view.image, difference);
      return cv::countNonZero(difference > 10);
    };
    QVERIFY(changed(cylindersInFront()) > 10000);
    QCOMPARE(changed(lyingLoad({0, 20, 5})), 0);   // out of the picture
    QCOMPARE(changed(lyingLoad({0, 0, -5})), 0);   // behind the camera
    QCOMPARE(changed(lyingLoad({0, 2.5, 9})), 0);  // under the ground
  }

  void theEndIsTheEndAndSeekingBeyondItChangesNothing() {
    const auto source = openDemoSource("wall", "");
    QVERIFY(source->seek(599));
    QVERIFY(!source->seek(600));
    QCOMPARE(source->next(patience).frame->sequence, std::uint64_t(599));
    QVERIFY(source->next(patience).status == ReadResult::Status::End);
    QVERIFY(source->next(patience).status == ReadResult::Status::End);
    QVERIFY(source->seek(0));
    QCOMPARE(source->next(patience).frame->sequence, std::uint64_t(0));
  }

  void anUnknownDemoIsRefusedByName() {
    const QString message = errorOf([] { openDemoSource("roof", "demo:roof"); });
    COMPARE_CONTAINS(message, QString("demo:roof"));
    COMPARE_CONTAINS(message, QString("demo:floor"));
  }
};

BOOMWATCH_TEST(TestDemoSource)
#include "test_demo_source.moc"
