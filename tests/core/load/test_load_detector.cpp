#include <QtTest>

#include "support/enumerators.h"
#include "support/load_errors.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3f;

namespace {

Cloud unorganised(Points points) {
  Cloud cloud;
  cloud.points = std::move(points);
  cloud.width = static_cast<int>(cloud.size());
  cloud.height = 1;
  return cloud;
}

const Vector3f toolAt4(0.1F, 0.2F, 4.0F);

LoadDetection detect(const Cloud& cloud, const Vector3f& tool = toolAt4,
                     LoadShape shape = LoadShape::Auto) {
  LoadParameters parameters;
  parameters.shape = shape;
  return detectLoad(cloud, tool, 0.0015, Bounds{}, parameters);
}

QString faultOf(const LoadDetection& detection) {
  const auto name = toString(detection.fault);
  return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

/// The first log that is found.
unsigned findable() {
  static const unsigned first = [] {
    unsigned seed = 0;
    for (;; ++seed) {
      const auto found = load_scene::detectIn(load_scene::logInGrapple(seed), seed);
      if (found && found->box) return seed;
    }
  }();
  return first;
}

}  // namespace

class TestLoadDetector : public QObject {
  Q_OBJECT
 private slots:
  // A matcher's rim lies behind the load, and no farther before it than noise puts it.
  void theVolumeReachesAlongTheLineOfSight() {
    const OrientedBox load{{0, 0, 5}, {1, 1, 1}, Eigen::Matrix3d::Identity()};
    const auto depth = dynamicVolume(load, 0.1, 0.001, 0.0);
    const auto stereo = dynamicVolume(load, 0.1, 0.001, 0.02);
    const auto behind = [](double inverse) {
      return Eigen::Vector3d(0, 0, 1 / (1 / 5.6 - inverse));
    };
    const auto before = [](double inverse) {
      return Eigen::Vector3d(0, 0, 1 / (1 / 4.4 + inverse));
    };
    QVERIFY(depth.contains(behind(0.0029)) && !depth.contains(behind(0.0031)));
    QVERIFY(stereo.contains(behind(0.0199)) && !stereo.contains(behind(0.0201)));
    QVERIFY(stereo.contains(before(0.0029)) && !stereo.contains(before(0.0031)));
  }

  // test_load_poses_slow has the full thousand.
  void logsAreFoundWhereTheyAre() {
    load_scene::Errors errors;
    load_scene::addPoses(errors, 1000, 20);
    qInfo("%s", qPrintable(errors.text()));
    QVERIFY(errors.found() >= 16);
    QVERIFY(load_scene::quantile(errors.axis, 0.5) < 3.0);
    QVERIFY(load_scene::quantile(errors.centre, 0.5) < 0.05);
    QVERIFY(load_scene::quantile(errors.radius, 0.5) < 0.10);
    QVERIFY(load_scene::quantile(errors.length, 0.5) < 0.10);
  }

  void anEmptyGrappleIsNoLoad() { QVERIFY(load_scene::falseLoads(1000, 20) <= 1); }

  void theSameFrameGivesTheSameBox() {
    const unsigned seed = findable();
    const auto scene = load_scene::logInGrapple(seed);
    const auto first = load_scene::detectIn(scene, seed),
               second = load_scene::detectIn(scene, seed);
    QCOMPARE(first->box->centre, second->box->centre);
    QCOMPARE(first->box->size, second->box->size);
  }

  void lockedSizesAreTheBoxs() {
    const unsigned seed = findable();
    const auto scene = load_scene::logInGrapple(seed);
    LoadParameters locked;
    locked.dimensions = LoadDimensions::Locked;
    locked.sizeX = scene.log->length, locked.sizeY = locked.sizeZ = 2.0 * scene.log->radius;
    const auto detection = load_scene::detectIn(scene, seed, locked);
    QVERIFY(detection && detection->box);
    const LoadDetection& found = *detection;
    QCOMPARE(found.box->size, Eigen::Vector3d(locked.sizeX, locked.sizeY, locked.sizeZ));
    QVERIFY((found.box->centre - scene.log->centre).norm() < 0.1);
  }

  void whatIsLargerThanAllowedIsRefused() {
    const unsigned seed = findable();
    const auto scene = load_scene::logInGrapple(seed);
    LoadParameters small;
    small.maxSize = scene.log->length * 0.8;
    const auto found = load_scene::detectIn(scene, seed, small);
    QVERIFY2(found && !found->box, qPrintable(faultOf(*found)));
  }

  void whatIsOutsideTheBoundsIsRefused() {
    const unsigned seed = findable();
    const auto scene = load_scene::logInGrapple(seed);
    const Cloud cloud = load_scene::cloudOf(scene, seed);
    const auto tool = load_scene::toolPointOf(scene, cloud, seed);
    Bounds bounds;
    bounds.zMax = scene.log->centre.z() - 2.5;
    bounds.zMin = bounds.zMax - 1.0;
    QVERIFY(!detectLoad(cloud, *tool, scene.depthNoise(), bounds, {}).box);
  }

  void aWallAtTheToolIsNoLoad() {
    Points points;
    for (int i = -200; i <= 200; ++i) {
      for (int j = -200; j <= 200; ++j) points.emplace_back(0.02F * i, 0.02F * j, 4.0F);
    }
    for (const auto shape : every<LoadShape>()) {
      const auto found = detect(unorganised(points), {0.1F, 0.2F, 4.0F}, shape);
      QCOMPARE(faultOf(found), QStringLiteral("on_surface"));
    }
  }

  void nothingUnderTheToolIsNoLoad() {
    const unsigned seed = findable();
    const auto scene = load_scene::logInGrapple(seed);
    Cloud cloud = load_scene::cloudOf(scene, seed);
    const auto tool = load_scene::toolPointOf(scene, cloud, seed);
    for (Vector3f& p : cloud.points) {
      if (isMeasured(p) && (p - *tool).norm() < 0.6F) p = unmeasuredPoint();
    }
    const auto found = detectLoad(cloud, *tool, scene.depthNoise(), load_scene::wideBounds(), {});
    QVERIFY(!found.box);
  }

  void oddCloudsAreRefused_data() {
    QTest::addColumn<Points>("points");
    Points collinear;
    for (int i = -500; i <= 500; ++i) collinear.push_back(toolAt4 + Vector3f(0.002F * i, 0, 0));
    Points towards;
    for (int i = -500; i <= 500; ++i) towards.push_back(toolAt4 * (1.0F + 0.001F * i));
    const float huge = 1e30F, tiny = 1e-30F;
    QTest::newRow("empty") << Points();
    QTest::newRow("one point") << Points{toolAt4};
    QTest::newRow("two points") << Points{toolAt4, {1, 1, 4}};
    QTest::newRow("all equal") << Points(5000, toolAt4);
    QTest::newRow("collinear") << collinear;
    QTest::newRow("collinear, towards the camera") << towards;
    QTest::newRow("NaN") << Points(5000, unmeasuredPoint());
    QTest::newRow("extreme") << Points{toolAt4,       {huge, huge, huge}, {tiny, tiny, tiny},
                                       {-huge, 0, 1}, {0, 0, -huge},      {0, 0, 0},
                                       toolAt4};
  }
  void oddCloudsAreRefused() {
    QFETCH(Points, points);
    const float huge = 1e30F;
    for (const auto shape : every<LoadShape>()) {
      for (const Vector3f& tool :
           {toolAt4, Vector3f(50, 50, 4), Vector3f(0, 0, 0), Vector3f(0, 0, -3), unmeasuredPoint(),
            Vector3f(huge, huge, huge), Vector3f(0, 0, 1e-30F)}) {
        const auto found = detect(unorganised(points), tool, shape);
        QVERIFY(!found.box);
        QVERIFY(found.fault != LoadFault::None);
      }
    }
  }

  void aToolPointBesideTheCloudIsRefused() {
    const unsigned seed = findable();
    const auto scene = load_scene::logInGrapple(seed);
    const Cloud cloud = load_scene::cloudOf(scene, seed);
    const Vector3f beside = (scene.log->centre * 0.5).cast<float>();
    const auto found = detectLoad(cloud, beside, scene.depthNoise(), load_scene::wideBounds(), {});
    QCOMPARE(faultOf(found), QStringLiteral("nothing_at_tool"));
  }
};

BOOMWATCH_TEST(TestLoadDetector)
#include "test_load_detector.moc"
