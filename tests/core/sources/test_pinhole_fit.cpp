#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <QtTest>
#include <random>

#include "sources/cloud_source.h"
#include "sources/pinhole_fit.h"
#include "support/camera_check.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr std::chrono::milliseconds patience{100};
constexpr PinholeCamera known{160, 120, 150.0, 140.0, 70.0, 65.5};
constexpr PinholeCamera other{160, 120, 90.0, 90.0, 79.5, 59.5};

/// Random depths along the rays of a camera; every seventh pixel measured nothing.
Cloud seenBy(const PinholeCamera& camera) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> depth(1.0, 9.0);
  Cloud cloud;
  cloud.width = camera.width;
  cloud.height = camera.height;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const bool measured = (u + 3 * v) % 7 != 0;
      const Eigen::Vector3d p = depth(random) * camera.ray(u, v);
      cloud.points.push_back(measured ? Eigen::Vector3f(p.cast<float>()) : unmeasuredPoint());
    }
  }
  return cloud;
}

Cloud scattered() {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> across(-1.0F, 1.0F);
  Cloud cloud;
  cloud.width = 100;
  cloud.height = 80;
  for (int k = 0; k < 8000; ++k) cloud.points.emplace_back(across(random), across(random), 3.0F);
  return cloud;
}

void writePcd(const TemporaryFolder& folder, const QString& name, const Cloud& cloud) {
  pcl::PointCloud<pcl::PointXYZ> peer(unsigned(cloud.width), unsigned(cloud.height));
  for (std::size_t k = 0; k < peer.size(); ++k) peer[k].getVector3fMap() = cloud.points[k];
  peer.is_dense = false;
  pcl::PCDWriter().writeBinary(folder.path(name).string(), peer);
}

bool isAbout(const PinholeCamera& a, const PinholeCamera& b) {
  return a.width == b.width && a.height == b.height && std::abs(a.fx - b.fx) < 1e-3 &&
         std::abs(a.fy - b.fy) < 1e-3 && std::abs(a.cx - b.cx) < 1e-3 &&
         std::abs(a.cy - b.cy) < 1e-3;
}

}  // namespace

class TestPinholeFit : public QObject {
  Q_OBJECT
 private slots:
  void recoversAKnownCamera() {
    const auto fit = fitPinhole(seenBy(known));
    QVERIFY(fit && isAbout(*fit, known));
  }

  void noCameraIsFittedToPointsOnNoRays() {
    QVERIFY(!fitPinhole(scattered()));
    Cloud line = seenBy(known);
    line.width *= line.height;
    line.height = 1;
    QVERIFY(!fitPinhole(line));
    QVERIFY(!fitPinhole(Cloud{}));
  }

  void aSourceOfFilesFitsOnce() {
    const TemporaryFolder folder;
    writePcd(folder, "1.pcd", seenBy(known));
    writePcd(folder, "2.pcd", seenBy(other));
    const auto source = openCloudSource(folder.path(), "");
    const FramePtr first = source->next(patience).frame;
    QVERIFY(missOfCamera(*first->cloud) < 1e-3);
    QVERIFY(isAbout(*first->cloud->camera, known));
    // The second file would give another camera, if it were fitted.
    const FramePtr second = source->next(patience).frame;
    QCOMPARE(second->cloud->camera, first->cloud->camera);
    // From the file that is read first, wherever that is.
    const auto backwards = openCloudSource(folder.path(), "");
    QVERIFY(backwards->seek(1));
    QVERIFY(isAbout(*backwards->next(patience).frame->cloud->camera, other));
  }

  void anotherSizeIsAnotherCamera() {
    constexpr PinholeCamera small{80, 60, 75.0, 75.0, 39.5, 29.5};
    const TemporaryFolder folder;
    writePcd(folder, "1.pcd", seenBy(known));
    writePcd(folder, "2.pcd", seenBy(small));
    const auto source = openCloudSource(folder.path(), "");
    QVERIFY(source->next(patience).status == ReadResult::Status::Ok);
    QVERIFY(isAbout(*source->next(patience).frame->cloud->camera, small));
  }

  void theFirstCloudThatFitsGivesTheCamera() {
    const TemporaryFolder folder;
    Cloud row = seenBy(known);
    row.width *= row.height;
    row.height = 1;
    writePcd(folder, "1.pcd", row);
    writePcd(folder, "2.pcd", scattered());
    writePcd(folder, "3.pcd", seenBy(known));
    writePcd(folder, "4.pcd", row);
    writePcd(folder, "5.pcd", seenBy(other));
    const auto source = openCloudSource(folder.path(), "");
    std::vector<std::optional<PinholeCamera>> cameras;
    for (int k = 0; k < 5; ++k) cameras.push_back(source->next(patience).frame->cloud->camera);
    QVERIFY(!cameras[0] && !cameras[1] && !cameras[3]);
    QVERIFY(cameras[2] && isAbout(*cameras[2], known));
    QCOMPARE(cameras[4], cameras[2]);
  }
};

BOOMWATCH_TEST(TestPinholeFit)
#include "test_pinhole_fit.moc"
