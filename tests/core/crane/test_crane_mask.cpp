#include <Eigen/Geometry>
#include <QtTest>

#include "crane/beam.h"
#include "crane/static_scene.h"
#include "pipeline/pipeline.h"
#include "simulation/yard/part.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr int width = 384, height = 288;
constexpr PinholeCamera camera{width, height, 250.0, 250.0, width / 2, height / 2};

const Part jib = rod({0.2, -3.0, 4.0}, {0.0, 0.0, 5.0}, 0.12);
const Vector3f tool(0.0F, -0.1F, 4.85F);
const Part wall = beam({-6.0, 0.0, 8.0}, {6.0, 0.0, 8.0}, 8.0, 0.2);

/// What the camera sees of these things.
Cloud seen(const Parts& parts) {
  Cloud cloud;
  cloud.width = width;
  cloud.height = height;
  cloud.camera = camera;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const Vector3d ray = camera.ray(u, v);
      std::optional<double> nearest;
      for (const Part& part : parts) {
        const auto hit = cast(part, Vector3d::Zero(), ray);
        if (hit && (!nearest || hit->depth < *nearest)) nearest = hit->depth;
      }
      cloud.points.push_back(nearest ? Vector3f((*nearest * ray).cast<float>())
                                     : unmeasuredPoint());
    }
  }
  return cloud;
}

std::size_t nearerThan(const Points& points, float z) {
  return static_cast<std::size_t>(
      std::ranges::count_if(points, [z](const Vector3f& p) { return p.z() < z; }));
}

StaticScene sceneOf(const Parts& parts) { return separateStatic(seen(parts), tool, {}, {}); }

}  // namespace

/// The crane among the clusters of a cloud.
class TestCraneMask : public QObject {
  Q_OBJECT

 private slots:
  void aBeamIsFoundAmongOtherPoints() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const Vector3d axis = Vector3d(1, 2, -1).normalized(), across(2, -1, 0);
    Points points;
    for (int i = 0; i < 600; ++i) {
      points.push_back((any(random) * axis + 0.03 * any(random) * across).cast<float>());
    }
    for (int i = 0; i < 300; ++i) points.emplace_back(any(random), any(random), any(random));
    const auto found = beamIn(points, 0.1);
    QVERIFY(found.has_value());
    QVERIFY(std::abs(found->axis.dot(axis)) > 0.999);
    BW_COMPARE_NEAR(found->length, 2.0, 0.15);
    BW_COMPARE_NEAR(found->share, 0.67, 0.06);
    QVERIFY(found->centre.norm() < 0.1);
  }

  void whatIsNotLongIsNoBeam() {
    QVERIFY(!beamIn({}, 0.1));
    QVERIFY(!beamIn(Points(50, Vector3f(1, 2, 3)), 0.1));
    Points ball;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(-0.1F, 0.1F);
    for (int i = 0; i < 200; ++i) ball.emplace_back(any(random), any(random), any(random));
    QVERIFY(!beamIn(ball, 0.2));
  }

  void theBoomBeyondAnElbowOutOfThePictureIsTheCranes() {
    const Part boom = rod({0.2, -3.0, 4.0}, {3.2, 1.0, 2.6}, 0.18);
    const StaticScene scene = sceneOf({jib, boom, wall});
    QCOMPARE(scene.toolMask, ToolMask::Taken);
    QVERIFY(scene.boomCut.size() > 50);
    QCOMPARE(nearerThan(scene.statics, 6.0F), std::size_t{0});
    QVERIFY(nearerThan(scene.statics, 9.0F) > 1000);
    // The tool's box does not grow by it.
    QVERIFY(scene.toolBox->max.x() < 0.5);
  }

  void theBoomBeyondIsWatchedAndNotNearItself() {
    const Part boom = rod({0.2, -3.0, 4.0}, {3.2, 1.0, 2.6}, 0.18);
    auto cloud = std::make_shared<const Cloud>(seen({jib, boom, wall}));
    Parameters parameters;
    parameters.watch.boom = true;
    Pipeline pipeline;
    pipeline.order(PickTool{{width / 2, height / 2 - 5}});
    Result result;
    for (std::uint64_t k = 0; k < 6; ++k) {
      auto frame = std::make_shared<Frame>();
      frame->sequence = k;
      frame->stamp = static_cast<double>(k) / 20.0;
      frame->left = cv::Mat(height, width, CV_8UC1, cv::Scalar(static_cast<double>(k)));
      frame->cloud = cloud;
      result = pipeline.process(frame, parameters);
    }
    bool isBeyond = false;
    for (const Watched& watched : result.watched) {
      if (watched.object != WatchedObject::Boom || !watched.box) continue;
      isBeyond = isBeyond || watched.box->centre.x() > 1.0;
      QVERIFY(watched.clearance.nearest && watched.clearance.nearest->distance > 2.0);
    }
    QVERIFY(isBeyond);
  }

  void aPoleThatPassesByTheJibIsNot() {
    // As straight, and cut by the picture's edges, too; but its axis meets nothing.
    const Part pole = rod({1.3, -4.0, 3.4}, {1.3, 4.0, 3.4}, 0.15);
    const StaticScene scene = sceneOf({jib, pole, wall});
    QCOMPARE(scene.toolMask, ToolMask::Taken);
    QVERIFY(scene.boomCut.empty());
    QVERIFY(nearerThan(scene.statics, 6.0F) > 100);
  }

  void whatEndsInThePictureIsNot() {
    // Its axis meets the jib's where the boom's would; it does not reach the edge of the picture.
    const Vector3d elbow(0.2, -3.0, 4.0), foot(3.2, 1.0, 2.6);
    const Part pole = rod(elbow + 0.45 * (foot - elbow), foot, 0.18);
    const StaticScene scene = sceneOf({jib, pole, wall});
    QCOMPARE(scene.toolMask, ToolMask::Taken);
    QVERIFY(scene.boomCut.empty());
    QVERIFY(nearerThan(scene.statics, 6.0F) > 50);
  }

  void aBroadThingIsNot() {
    const Part board = beam({0.2, -3.0, 4.0}, {3.2, 1.0, 2.6}, 1.2, 0.1);
    const StaticScene scene = sceneOf({jib, board, wall});
    QVERIFY(scene.boomCut.empty());
    QVERIFY(nearerThan(scene.statics, 6.0F) > 100);
  }

  void whereTheLoadStandsOnTheGroundTheToolIsStillFound() {
    // The jib is joined with the wall by the load alone.
    const Part load = rod({0.0, 0.1, 5.0}, {0.0, 2.8, 8.0}, 0.2);
    const Cloud cloud = seen({jib, load, wall});
    const StaticScene unknown = separateStatic(cloud, tool, {}, {});
    QCOMPARE(unknown.toolMask, ToolMask::TooLarge);
    QVERIFY(nearerThan(unknown.statics, 5.2F) > 100);
    OrientedBox volume = load.box;
    volume.size += Vector3d::Constant(0.1);
    const StaticScene known = separateStatic(cloud, tool, volume, {});
    QCOMPARE(known.toolMask, ToolMask::Taken);
    QCOMPARE(nearerThan(known.statics, 6.0F), std::size_t{0});
    QVERIFY(nearerThan(known.statics, 9.0F) > 1000);
  }

  /// The far end of a log that points at the camera is seen apart from the tool. As long as no load
  /// is found, that is no obstacle to be learnt, nor is it the crane.
  void whatMayBeALoadThatWasNotFoundIsTakenOut() {
    const Part piece = beam({0.9, 0.0, 5.4}, {1.1, 0.0, 5.6}, 0.3, 0.3);
    const Parts parts{jib, wall, piece};
    const auto atComponent = [](const Points& points) {
      return std::ranges::count_if(points,
                                   [](const Vector3f& p) { return p.x() > 0.7F && p.z() < 6.0F; });
    };
    const StaticScene none = separateStatic(seen(parts), tool, {}, {});
    QVERIFY(atComponent(none.statics) > 10);
    QCOMPARE(none.maybeLoad, std::size_t{0});
    const StaticScene maybe = separateStatic(seen(parts), tool, {}, {}, {}, true);
    QCOMPARE(atComponent(maybe.statics), 0);
    QCOMPARE(maybe.maybeLoad, static_cast<std::size_t>(atComponent(maybe.removed)));
    QCOMPARE(atComponent(maybe.toolCluster), 0);
    QCOMPARE(nearerThan(maybe.statics, 9.0F), nearerThan(none.statics, 9.0F) - maybe.maybeLoad);

    Parameters small;
    small.load.maxSize = 1.6;  // it lies 1.1 to 1.4 m from the tool
    QVERIFY(atComponent(separateStatic(seen(parts), tool, {}, small, {}, true).statics) > 10);
  }
};

BOOMWATCH_TEST(TestCraneMask)
#include "test_crane_mask.moc"
