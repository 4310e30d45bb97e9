#include <QtTest>
#include <random>

#include "cloud/depth_noise.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr int width = 160, height = 120;
constexpr float focal = 130.0F;

/// What a camera sees of a surface: depth by pixel.
template <class Depth>
std::shared_ptr<Cloud> seen(Depth depth) {
  auto cloud = std::make_shared<Cloud>();
  cloud->width = width;
  cloud->height = height;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const float z = depth(u, v);
      cloud->points.emplace_back(static_cast<float>(u - width / 2) / focal * z,
                                 static_cast<float>(v - height / 2) / focal * z, z);
    }
  }
  return cloud;
}

/// A wall at 5 m before one at 7 m.
float step(int u, int) { return u < width / 2 ? 5.0F : 7.0F; }
/// A floor that goes away from the camera: 1/z is linear in the pixel.
float slope(int, int v) { return 1.0F / (0.1F + 0.001F * static_cast<float>(v)); }

/// The same with normal noise of 1/z.
std::shared_ptr<Cloud> noisy(const Cloud& exact, double deviation) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, deviation);
  auto cloud = std::make_shared<Cloud>(exact);
  for (Eigen::Vector3f& p : cloud->points) {
    const double z = static_cast<double>(p.z());
    p *= static_cast<float>(1.0 / (1.0 + z * noise(random)));
  }
  return cloud;
}

/// Root mean square of what z is off, metres.
double error(const Cloud& cloud, const Cloud& exact) {
  double sum = 0.0;
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    const double off = static_cast<double>(cloud.points[k].z() - exact.points[k].z());
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(cloud.size()));
}

}  // namespace

class TestDepthNoise : public QObject {
  Q_OBJECT

 private slots:
  void theNoiseIsMeasured() {
    for (const double deviation : {0.0005, 0.0014, 0.003}) {
      const auto measured = depthNoise(*noisy(*seen(slope), deviation));
      QVERIFY(measured);
      BW_COMPARE_NEAR(*measured, deviation, 0.1 * deviation);
    }
    QVERIFY(*depthNoise(*seen(step)) < 1e-6);
  }

  void itIsTakenOutAndEdgesStay() {
    for (const auto& exact : {seen(step), seen(slope)}) {
      const auto smooth = withoutDepthNoise(noisy(*exact, 0.0014), 5);
      // The mean of 25 has a fifth of the noise; at the border there are fewer.
      QVERIFY(error(*smooth, *exact) < error(*noisy(*exact, 0.0014), *exact) / 4.0);
    }
    // The columns of pixels at the edge are as good as all others.
    const auto exact = seen(step);
    const auto smooth = withoutDepthNoise(noisy(*exact, 0.0014), 5);
    for (int v = 5; v < height - 5; ++v) {
      for (const int u : {width / 2 - 1, width / 2}) {
        BW_COMPARE_NEAR(smooth->at(u, v).z(), exact->at(u, v).z(), 0.1F);
        // Along its ray: it stays in its pixel.
        const auto& p = smooth->at(u, v);
        BW_COMPARE_NEAR(p.x() / p.z() * focal, static_cast<float>(u - width / 2), 1e-3F);
      }
    }
  }

  void whatHasNoNoiseIsTheSameCloud() {
    const auto exact = seen(slope);
    QCOMPARE(withoutDepthNoise(exact, 5).get(), exact.get());
    const auto rough = noisy(*exact, 0.0014);
    QCOMPARE(withoutDepthNoise(rough, 1).get(), rough.get());
  }

  void gapsStayGapsAndSpoilNothing() {
    auto rough = noisy(*seen(slope), 0.0014);
    std::mt19937 random(9);
    std::vector<std::size_t> gaps;
    for (int k = 0; k < 4000; ++k) gaps.push_back(random() % rough->size());
    for (const std::size_t k : gaps) rough->points[k] = unmeasuredPoint();
    const auto smooth = withoutDepthNoise(rough, 5);
    for (std::size_t k = 0; k < rough->size(); ++k) {
      QCOMPARE(isMeasured(smooth->points[k]), isMeasured(rough->points[k]));
    }
  }

  void whatIsNotOrganisedOrHoldsNothingStays() {
    auto line = std::make_shared<Cloud>();
    line->points.assign(1000, Eigen::Vector3f(0, 0, 3));
    line->width = 1000;
    line->height = 1;
    QVERIFY(!depthNoise(*line));
    QCOMPARE(withoutDepthNoise(line, 5).get(), line.get());
    const auto empty = seen([](int, int) { return std::numeric_limits<float>::quiet_NaN(); });
    QVERIFY(!depthNoise(*empty));
    QCOMPARE(withoutDepthNoise(empty, 5).get(), empty.get());
    const auto nowhere = std::make_shared<Cloud>();
    QCOMPARE(withoutDepthNoise(nowhere, 5).get(), nowhere.get());
  }
};

BOOMWATCH_TEST(TestDepthNoise)
#include "test_depth_noise.moc"
