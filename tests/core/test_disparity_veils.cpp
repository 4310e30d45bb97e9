#include <QtTest>
#include <limits>

#include "stereo/disparity_veils.h"

using boomwatch::withoutVeils;

namespace {

constexpr int width = 60, height = 40;

template <class Disparity>
cv::Mat mapOf(Disparity disparity) {
  cv::Mat map(height, width, CV_32FC1);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) map.at<float>(v, u) = disparity(u, v);
  }
  return map;
}

int gapsIn(const cv::Mat& map) {
  int gaps = 0;
  for (int v = 0; v < map.rows; ++v) {
    for (int u = 0; u < map.cols; ++u) gaps += std::isnan(map.at<float>(v, u));
  }
  return gaps;
}

}  // namespace

class TestDisparityVeils : public QObject {
  Q_OBJECT

 private slots:
  void surfacesStay() {
    const cv::Mat ground = mapOf([](int, int v) { return 10.0F + 0.5F * static_cast<float>(v); });
    const cv::Mat wall = mapOf([](int u, int) { return 50.0F - 0.5F * static_cast<float>(u); });
    QCOMPARE(gapsIn(withoutVeils(ground, 0.6)), 0);
    QCOMPARE(gapsIn(withoutVeils(wall, 0.6)), 0);
    QVERIFY(gapsIn(withoutVeils(wall, 0.4)) > 0);
  }

  // 30 pixels before 24, and between them a slope of 4 columns.
  void theSlopeBetweenTwoSurfacesGoes() {
    const cv::Mat map = mapOf([](int u, int) {
      return u < 30 ? 30.0F : u >= 34 ? 24.0F : 30.0F - 1.5F * static_cast<float>(u - 29);
    });
    const cv::Mat clear = withoutVeils(map, 0.6);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const bool veil = u >= 30 && u < 34;
        // Of each surface no more than a pixel goes with it.
        if (veil) QVERIFY(std::isnan(clear.at<float>(v, u)));
        if (u < 29 || u > 34) QCOMPARE(clear.at<float>(v, u), map.at<float>(v, u));
      }
    }
  }

  void anEdgeWithoutOneLosesAPixelAtMost() {
    const cv::Mat map = mapOf([](int, int v) { return v < 20 ? 30.0F : 24.0F; });
    QCOMPARE(gapsIn(withoutVeils(map, 0.6)), 2 * (width - 2));
  }

  void gapsAreNoSlopes() {
    const cv::Mat map = mapOf([](int u, int v) {
      return (u + v) % 3 == 0 ? std::numeric_limits<float>::quiet_NaN() : 20.0F;
    });
    QCOMPARE(gapsIn(withoutVeils(map, 0.6)), gapsIn(map));
    QVERIFY(withoutVeils(cv::Mat(), 0.6).empty());
  }
};

QTEST_APPLESS_MAIN(TestDisparityVeils)
#include "test_disparity_veils.moc"
