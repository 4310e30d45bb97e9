#include <QtTest>
#include <limits>

#include "stereo/flying_pixels.h"
#include "support/test_registry.h"

namespace {

cv::Mat withoutFlyingPixels(const cv::Mat& disparity, double steepest, double focalLength = 600.0) {
  return boomwatch::withoutFlyingPixels(disparity, steepest, focalLength);
}

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

class TestFlyingPixels : public QObject {
  Q_OBJECT

 private slots:
  void surfacesStay() {
    const cv::Mat ground = mapOf([](int, int v) { return 10.0F + 0.5F * static_cast<float>(v); });
    const cv::Mat wall = mapOf([](int u, int) { return 50.0F - 0.5F * static_cast<float>(u); });
    QCOMPARE(gapsIn(withoutFlyingPixels(ground, 0.6)), 0);
    QCOMPARE(gapsIn(withoutFlyingPixels(wall, 0.6)), 0);
    QVERIFY(gapsIn(withoutFlyingPixels(wall, 0.4)) > 0);
  }

  // 30 pixels before 24, and between them a slope of 4 columns.
  void theSlopeBetweenTwoSurfacesGoes() {
    const cv::Mat map = mapOf([](int u, int) {
      return u < 30 ? 30.0F : u >= 34 ? 24.0F : 30.0F - 1.5F * static_cast<float>(u - 29);
    });
    const cv::Mat clear = withoutFlyingPixels(map, 0.6);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const bool veil = u >= 30 && u < 34;
        // Of each surface no more than a pixel goes with it.
        if (veil) QVERIFY(std::isnan(clear.at<float>(v, u)));
        if (u < 29 || u > 34) QCOMPARE(clear.at<float>(v, u), map.at<float>(v, u));
      }
    }
  }

  // The rim of a near thing that is drawn out towards a gap, more gently than a surface may slope.
  void aNarrowRimGoesAndAWideSlopeStays() {
    const auto slopesOver = [](int columns) {
      return [columns](int along, bool gap) {
        if (along < 20) return 30.0F;
        if (along < 20 + columns) return 30.0F - 0.4F * static_cast<float>(along - 19);
        return gap ? std::numeric_limits<float>::quiet_NaN() : 24.0F;
      };
    };
    for (const bool gap : {true, false}) {
      const auto rim = slopesOver(8), wide = slopesOver(14);
      const cv::Mat across = mapOf([&](int u, int) { return rim(u, gap); });
      const cv::Mat down = mapOf([&](int, int v) { return rim(v, gap); });
      const cv::Mat clearAcross = withoutFlyingPixels(across, 0.6),
                    clearDown = withoutFlyingPixels(down, 0.6);
      for (int k = 0; k < height; ++k) {
        const bool veil = k >= 20 && k < 28;
        if (veil) QVERIFY(std::isnan(clearAcross.at<float>(5, k)));
        if (veil) QVERIFY(std::isnan(clearDown.at<float>(k, 5)));
        if (k < 19) QCOMPARE(clearAcross.at<float>(5, k), across.at<float>(5, k));
        if (k < 19) QCOMPARE(clearDown.at<float>(k, 5), down.at<float>(k, 5));
      }
      const cv::Mat surface =
          withoutFlyingPixels(mapOf([&](int u, int) { return wide(u, gap); }), 0.6);
      for (int u = 21; u < 32; ++u) QVERIFY(!std::isnan(surface.at<float>(5, u)));
    }
  }
  // So near that a surface may be as steep, as a head that is seen from above is at its rim.
  void aRimOfWhatIsVeryNearStays() {
    const cv::Mat map = mapOf([](int u, int) {
      const float at = 60.0F - 0.4F * static_cast<float>(std::clamp(u - 19, 0, 8));
      return u < 28 ? at : std::numeric_limits<float>::quiet_NaN();
    });
    QCOMPARE(gapsIn(withoutFlyingPixels(map, 0.6)), gapsIn(map));
  }
  void aRimAtTheBorderOfThePictureGoes() {
    const cv::Mat map = mapOf([](int u, int) {
      return u < width - 6 ? 30.0F : 30.0F - 0.4F * static_cast<float>(u - (width - 7));
    });
    const cv::Mat clear = withoutFlyingPixels(map, 0.6);
    for (int u = width - 6; u < width - 1; ++u) QVERIFY(std::isnan(clear.at<float>(5, u)));
  }

  void anEdgeWithoutOneLosesAPixelAtMost() {
    const cv::Mat map = mapOf([](int, int v) { return v < 20 ? 30.0F : 24.0F; });
    QCOMPARE(gapsIn(withoutFlyingPixels(map, 0.6)), 2 * width);
  }

  void gapsAreNoSlopes() {
    const cv::Mat map = mapOf([](int u, int v) {
      return (u + v) % 3 == 0 ? std::numeric_limits<float>::quiet_NaN() : 20.0F;
    });
    QCOMPARE(gapsIn(withoutFlyingPixels(map, 0.6)), gapsIn(map));
    QVERIFY(withoutFlyingPixels(cv::Mat(), 0.6).empty());
  }
};

BOOMWATCH_TEST(TestFlyingPixels)
#include "test_flying_pixels.moc"
