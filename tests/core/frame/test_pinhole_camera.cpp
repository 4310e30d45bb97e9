#include <QtTest>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <random>

#include "frame/cloud.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr PinholeCamera camera{640, 480, 500.0, 510.0, 310.0, 250.0};

}  // namespace

class TestPinholeCamera : public QObject {
  Q_OBJECT
 private slots:
  void projectsAsTheEquationSays() {
    QCOMPARE(camera.project({0.0, 0.0, 7.0}), Vector2d(310.0, 250.0));
    QCOMPARE(camera.project({1.0, -2.0, 4.0}), Vector2d(310.0 + 125.0, 250.0 - 255.0));
  }

  void projectsAsOpenCvDoes() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> across(-3.0, 3.0), deep(0.5, 12.0);
    const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
    std::vector<cv::Point3d> points;
    for (int k = 0; k < 100; ++k) points.emplace_back(across(random), across(random), deep(random));
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), matrix, cv::noArray(), pixels);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vector2d pixel = camera.project({points[k].x, points[k].y, points[k].z});
      QVERIFY((pixel - Vector2d(pixels[k].x, pixels[k].y)).norm() < 1e-9);
    }
  }

  void aRayLeadsToThePointsThatItsPixelShows() {
    QCOMPARE(camera.ray(310.0, 250.0), Vector3d(0.0, 0.0, 1.0));
    QCOMPARE(camera.ray(810.0, -5.0), Vector3d(1.0, -0.5, 1.0));
    for (const double z : {0.1, 3.0, 40.0}) {
      QVERIFY((camera.project(z * camera.ray(17.25, 401.5)) - Vector2d(17.25, 401.5)).norm() <
              1e-9);
    }
  }

  void aCentredCameraSeesAsFarToBothSides() {
    constexpr PinholeCamera centred = PinholeCamera::centred(768, 576, 600.0);
    QCOMPARE(centred, (PinholeCamera{768, 576, 600.0, 600.0, 383.5, 287.5}));
    QCOMPARE(centred.ray(0, 0).x(), -centred.ray(767, 0).x());
    QCOMPARE(centred.ray(0, 0).y(), -centred.ray(0, 575).y());
  }

  void containsItsPixelsOnly() {
    QVERIFY(camera.contains({0.0, 0.0}) && camera.contains({639.0, 479.0}));
    QVERIFY(!camera.contains({-0.01, 5.0}) && !camera.contains({5.0, -0.01}));
    QVERIFY(!camera.contains({640.0, 5.0}) && !camera.contains({5.0, 480.0}));
    QVERIFY(!camera.contains({std::numeric_limits<double>::quiet_NaN(), 5.0}));
  }

  // The exact depths of disparities a pixel, and a quarter of one, apart: z = f B / d.
  void theNoiseOfAStereoPairIsThatOfItsDisparity() {
    constexpr double fB = 600.0 * 0.24, disparity = 20.0;
    constexpr DepthNoise noise = DepthNoise::ofStereo(600.0, 0.24);
    const double z = fB / disparity;
    QVERIFY(std::abs(1.0 / (fB / (disparity + 1.0)) - 1.0 / z - noise.perPixel) < 1e-12);
    const double nearer = fB / (disparity + 0.25), farther = fB / (disparity - 0.25);
    QVERIFY(std::abs(noise.at(z) - (farther - nearer) / 2.0) < 1e-3 * noise.at(z));
  }

  void aCloudWithoutAFigureHasTheNoiseOfADepthCamera() {
    const Cloud cloud;
    QCOMPARE(cloud.noise.at(2.0), 0.0056);
    QCOMPARE(cloud.noise.perPixel, 0.0);
    QVERIFY(!cloud.camera);
  }
};

BOOMWATCH_TEST(TestPinholeCamera)
#include "test_pinhole_camera.moc"
