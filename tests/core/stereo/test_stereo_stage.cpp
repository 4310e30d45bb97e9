#include <QtTest>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/error.h"
#include "stereo/stereo_stage.h"
#include "support/camera_check.h"
#include "support/enumerators.h"
#include "support/real_data.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

cv::Mat texture(cv::Size size) {
  cv::Mat image(size, CV_8UC1);
  cv::RNG(7).fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(image, image, {}, 1.2);
  cv::normalize(image, image, 0, 255, cv::NORM_MINMAX);
  return image;
}

StereoRig rectifiedRig(cv::Size size, double f, double baseline, double doffs = 0) {
  StereoRig rig;
  rig.imageSize = size;
  rig.leftMatrix = {f, 0, size.width / 2.0, 0, f, size.height / 2.0, 0, 0, 1};
  rig.rightMatrix = rig.leftMatrix;
  rig.rightMatrix(0, 2) += doffs;
  rig.translation = {-baseline, 0, 0};
  rig.rectified = true;
  return rig;
}

struct Pair {
  cv::Mat left, right;
};

// What the two cameras see of a textured plane n.X = offset, ray by ray.
Pair renderPlane(const StereoRig& rig, const cv::Vec3d& normal, double offset) {
  const cv::Size size = rig.imageSize;
  const cv::Mat paint = texture({1600, 1600});
  auto render = [&](const cv::Matx33d& k, const cv::Mat& d, const cv::Matx33d& r,
                    const cv::Vec3d& t) {
    std::vector<cv::Point2d> pixels, rays;
    for (int v = 0; v < size.height; ++v) {
      for (int u = 0; u < size.width; ++u) pixels.emplace_back(u, v);
    }
    cv::undistortPoints(pixels, rays, k, d, cv::noArray(), cv::noArray(),
                        cv::TermCriteria(cv::TermCriteria::COUNT, 40, 0));
    const cv::Vec3d centre = -(r.t() * t);
    cv::Mat map(size, CV_32FC2);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const cv::Vec3d ray = r.t() * cv::Vec3d(rays[i].x, rays[i].y, 1);
      const cv::Vec3d hit = centre + ray * ((offset - normal.dot(centre)) / normal.dot(ray));
      // 200 texels a metre, so that a texel is about as large as a pixel at 2.5 m.
      map.at<cv::Vec2f>(static_cast<int>(i)) = {static_cast<float>(800 + 200 * hit[0]),
                                                static_cast<float>(800 + 200 * hit[1])};
    }
    cv::Mat image;
    cv::remap(paint, image, map, cv::noArray(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
    return image;
  };
  return {render(rig.leftMatrix, rig.leftDistortion, cv::Matx33d::eye(), {}),
          render(rig.rightMatrix, rig.rightDistortion, rig.rotation, rig.translation)};
}

struct Errors {
  double fill = 0;    // share of points that were measured
  double mean = 0;    // the rest in pixels of disparity, signed
  double median = 0;  // of the absolute error
  double within = 0;  // share that errs by less than half a pixel
};

Errors errorsAgainstPlane(const StereoResult& result, const cv::Vec3d& normal, double offset) {
  std::vector<double> errors;
  Errors all;
  for (const auto& p : result.cloud->points) {
    if (!isMeasured(p)) continue;
    const double z = offset / normal.dot(cv::Vec3d(p.x() / p.z(), p.y() / p.z(), 1));
    const double error = (1 / p.z() - 1 / z) / result.cloud->noise.perPixel;
    all.mean += error;
    errors.push_back(std::abs(error));
  }
  if (errors.empty()) return all;
  const auto count = static_cast<double>(errors.size());
  std::sort(errors.begin(), errors.end());
  all.fill = count / static_cast<double>(result.cloud->size());
  all.mean /= count;
  all.median = errors[errors.size() / 2];
  all.within =
      static_cast<double>(std::lower_bound(errors.begin(), errors.end(), 0.5) - errors.begin()) /
      count;
  return all;
}

// A quarter of a pixel of depth error, no bias, and few outliers.
void verifyPlane(const StereoResult& result, const cv::Vec3d& normal, double offset) {
  const auto errors = errorsAgainstPlane(result, normal, offset);
  const QString found = QString("fill %1, mean %2, median %3, within %4")
                            .arg(errors.fill)
                            .arg(errors.mean)
                            .arg(errors.median)
                            .arg(errors.within);
  QVERIFY2(errors.fill > 0.7, qPrintable(found));
  QVERIFY2(std::abs(errors.mean) < 0.05, qPrintable(found));
  QVERIFY2(errors.median < 0.25, qPrintable(found));
  QVERIFY2(errors.within > 0.97, qPrintable(found));
}

cv::Mat measured(const cv::Mat& disparity) { return disparity == disparity; }

// The same pixels measured, and the same numbers in them.
bool same(const cv::Mat& a, const cv::Mat& b) {
  const cv::Mat mask = measured(a);
  return cv::norm(mask, measured(b), cv::NORM_INF) == 0 && cv::norm(a, b, cv::NORM_INF, mask) == 0;
}

std::size_t measuredCount(const cv::Mat& disparity) {
  return static_cast<std::size_t>(cv::countNonZero(measured(disparity)));
}

}  // namespace

class TestStereoMatcher : public QObject {
  Q_OBJECT

 private slots:
  void equalsOpenCvsMatcherCalledDirectly_data() {
    QTest::addColumn<bool>("bm");
    QTest::newRow("sgbm") << false;
    QTest::newRow("bm") << true;
  }
  void equalsOpenCvsMatcherCalledDirectly() {
    QFETCH(bool, bm);
    const QString folder = "/usr/share/doc/opencv-doc/examples/data/";
    REQUIRE_DATA(folder + "aloeL.jpg");
    auto read = [&](const char* name) {
      cv::Mat image = cv::imread((folder + name).toStdString(), cv::IMREAD_GRAYSCALE);
      cv::resize(image, image, {}, 0.5, 0.5, cv::INTER_AREA);
      return image;
    };
    const cv::Mat left = read("aloeL.jpg"), right = read("aloeR.jpg");
    StereoParameters p;
    p.disparities = 128;
    p.blockSize = bm ? 11 : 5;
    p.matcher = bm ? StereoMatcherKind::Bm : StereoMatcherKind::Sgbm;
    cv::Ptr<cv::StereoMatcher> peer;
    if (bm) {
      auto matcher = cv::StereoBM::create(128, 11);
      matcher->setPreFilterCap(31);
      matcher->setTextureThreshold(10);
      matcher->setUniquenessRatio(10);
      matcher->setSpeckleRange(32);
      matcher->setSpeckleWindowSize(100);
      matcher->setDisp12MaxDiff(1);
      peer = matcher;
    } else {
      peer = cv::StereoSGBM::create(0, 128, 5, 200, 800, 1, 31, 10, 100, 2,
                                    cv::StereoSGBM::MODE_SGBM_3WAY);
    }
    cv::Mat raw, expected;
    peer->compute(left, right, raw);
    raw.convertTo(expected, CV_32F, 1.0 / 16);
    const cv::Mat disparity = matchDisparity(left, right, p);
    expected.setTo(std::numeric_limits<float>::quiet_NaN(), raw < 0);
    QVERIFY(measuredCount(disparity) > disparity.total() / 3);
    QVERIFY(same(disparity, expected));
  }

  void givesTheDepthOfAPlane_data() {
    QTest::addColumn<int>("matcher");
    QTest::addColumn<double>("doffs");
    QTest::newRow("sgbm") << 0 << 0.0;
    QTest::newRow("bm") << 1 << 0.0;
    QTest::newRow("principal points differ") << 0 << 9.5;
    QTest::newRow("principal points differ the other way") << 0 << -8.25;
  }
  void givesTheDepthOfAPlane() {
    QFETCH(int, matcher);
    QFETCH(double, doffs);
    const auto rig = rectifiedRig({480, 320}, 400, 0.2, doffs);
    const cv::Vec3d normal = cv::normalize(cv::Vec3d(0.1, -0.05, 1));
    const auto pair = renderPlane(rig, normal, 2.5);
    StereoParameters p;
    p.matcher = static_cast<StereoMatcherKind>(matcher);
    p.blockSize = matcher ? 11 : 5;
    StereoStage stage;
    const auto result = stage.process(pair.left, pair.right, rig, p);
    QCOMPARE(*result.cloud->camera, (PinholeCamera{480, 320, 400.0, 400.0, 240.0, 160.0}));
    QCOMPARE(*result.surfaces->camera, *result.cloud->camera);
    QVERIFY(missOfCamera(*result.cloud) < 1e-3);
    QCOMPARE(result.cloud->noise.perPixel, 1.0 / (400.0 * 0.2));
    QCOMPARE(result.cloud->width, 480);
    QCOMPARE(result.cloud->height, 320);
    verifyPlane(result, normal, 2.5);
  }

  void rectifiesATurnedAndDistortedPair() {
    StereoRig rig = rectifiedRig({480, 320}, 400, 0.2);
    rig.rectified = false;
    rig.rightMatrix = {410, 0, 236, 0, 408, 164, 0, 0, 1};
    rig.leftDistortion = (cv::Mat_<double>(1, 5) << -0.12, 0.03, 0.001, -0.0005, 0);
    rig.rightDistortion = (cv::Mat_<double>(1, 4) << -0.10, 0.02, -0.001, 0.0004);
    cv::Rodrigues(cv::Vec3d(0.02, -0.03, 0.015), rig.rotation);
    rig.translation = {-0.2, 0.006, -0.004};
    const cv::Vec3d normal = cv::normalize(cv::Vec3d(-0.08, 0.1, 1));
    const auto pair = renderPlane(rig, normal, 2.5);
    StereoStage stage;
    const auto result = stage.process(pair.left, pair.right, rig, {});
    const double perPixel = result.cloud->noise.perPixel;
    QVERIFY(std::abs(1.0 / (result.cloud->camera->fx * perPixel) - cv::norm(rig.translation)) <
            1e-9);
    QVERIFY(missOfCamera(*result.cloud) < 1e-3);
    // The cloud is in the rectified camera's frame, which R1 turns from the left camera's.
    cv::Matx33d r1, r2;
    cv::Matx34d p1, p2;
    cv::Mat q;
    cv::stereoRectify(rig.leftMatrix, rig.leftDistortion, rig.rightMatrix, rig.rightDistortion,
                      rig.imageSize, rig.rotation, rig.translation, r1, r2, p1, p2, q,
                      cv::CALIB_ZERO_DISPARITY, 0);
    verifyPlane(result, r1 * normal, 2.5);
  }

  void followsTheRigWhenItChanges() {
    const auto rig = rectifiedRig({480, 320}, 400, 0.2);
    const auto pair = renderPlane(rig, {0, 0, 1}, 2.5);
    StereoRig wider = rig;
    wider.translation *= 2;
    StereoStage stage;
    const auto once = stage.process(pair.left, pair.right, rig, {});
    const auto twice = stage.process(pair.left, pair.right, wider, {});
    const auto a = once.cloud->at(240, 160), b = twice.cloud->at(240, 160);
    QVERIFY(isMeasured(a));
    QVERIFY((b - 2 * a).norm() < 1e-4f);
  }

  void keepsColourInTheLeftImageAndMatchesInGrey() {
    const auto rig = rectifiedRig({480, 320}, 400, 0.2);
    const auto pair = renderPlane(rig, {0, 0, 1}, 2.5);
    cv::Mat left, right;
    cv::cvtColor(pair.left, left, cv::COLOR_GRAY2BGR);
    cv::cvtColor(pair.right, right, cv::COLOR_GRAY2BGR);
    StereoStage stage;
    const auto grey = stage.process(pair.left, pair.right, rig, {});
    const auto colour = stage.process(left, right, rig, {});
    QCOMPARE(colour.left.type(), CV_8UC3);
    QCOMPARE(grey.left.type(), CV_8UC1);
    QVERIFY(same(grey.disparity, colour.disparity));
  }

  void givesNoPointAtInfinity() {
    // Both cameras see the same picture: every disparity is 0.
    const cv::Mat image = texture({320, 240});
    StereoStage stage;
    const auto rig = rectifiedRig(image.size(), 300, 0.1);
    const auto result = stage.process(image, image, rig, {});
    QVERIFY(measuredCount(result.disparity) > image.total() / 2);
    for (const auto& p : result.cloud->points) {
      QVERIFY(!isMeasured(p) || p.z() < 1000);
      QVERIFY(isMeasured(p) || (std::isnan(p.x()) && std::isnan(p.y()) && std::isnan(p.z())));
    }
    QVERIFY(!isMeasured(result.cloud->at(200, 120)));
  }

  void measuresNothingInAPictureWithoutTexture() {
    const cv::Mat flat(240, 320, CV_8UC1, cv::Scalar(128));
    StereoParameters bm;
    bm.matcher = StereoMatcherKind::Bm;
    bm.blockSize = 9;
    QCOMPARE(measuredCount(matchDisparity(flat, flat, bm)), std::size_t{0});
  }

  void measuresNothingInAnImageSmallerThanTheSearch() {
    for (const cv::Size size :
         {cv::Size(1, 1), cv::Size(64, 48), cv::Size(69, 48), cv::Size(200, 3), cv::Size(3, 200)}) {
      for (const auto matcher : every<StereoMatcherKind>()) {
        StereoParameters p;
        p.matcher = matcher;
        const cv::Mat image = texture(size);
        QCOMPARE(measuredCount(matchDisparity(image, image, p)), std::size_t{0});
      }
    }
  }

  void survivesEverySettingTheTableAllows() {
    const cv::Mat image = texture({180, 90});
    cv::RNG random(3);
    for (int i = 0; i < 300; ++i) {
      StereoParameters p;
      p.matcher = static_cast<StereoMatcherKind>(i % 2);
      p.minDisparity = random.uniform(-512, 513);
      p.disparities = 16 * random.uniform(1, 65);
      p.blockSize = random.uniform(1, 52);
      p.uniqueness = random.uniform(0, 101);
      p.consistency = random.uniform(-1, 101);
      p.speckleWindow = random.uniform(0, 1000);
      p.speckleRange = random.uniform(0, 101);
      p.preFilterCap = random.uniform(1, 64);
      p.texture = random.uniform(0.0, 50.0);
      try {
        QCOMPARE(matchDisparity(image, image, p).size(), image.size());
      } catch (const Error& fault) {
        QVERIFY2(QString(fault.what()).contains("stereo_"), fault.what());
      }
    }
  }

  void refusesWhatDoesNotFit() {
    const cv::Mat image = texture({320, 240});
    const auto rig = rectifiedRig({640, 480}, 300, 0.1);
    StereoStage stage;
    try {
      stage.process(image, image, rig, {});
      QFAIL("the calibration is for another size");
    } catch (const Error& fault) {
      QVERIFY(QString(fault.what()).contains("640 x 480"));
      QVERIFY(QString(fault.what()).contains("320 x 240"));
    }
    const auto other = rectifiedRig({}, 300, 0.1);
    QVERIFY_EXCEPTION_THROWN(stage.process(image, texture({300, 240}), other, {}), Error);
    QVERIFY_EXCEPTION_THROWN(stage.process({}, {}, other, {}), Error);
    cv::Mat deep;
    image.convertTo(deep, CV_16U);
    QVERIFY_EXCEPTION_THROWN(stage.process(deep, deep, other, {}), Error);
    StereoParameters even;
    even.blockSize = 6;
    QVERIFY_EXCEPTION_THROWN(matchDisparity(image, image, even), Error);
    StereoParameters small;
    small.matcher = StereoMatcherKind::Bm;
    small.blockSize = 3;
    QVERIFY_EXCEPTION_THROWN(matchDisparity(image, image, small), Error);
    StereoParameters odd;
    odd.disparities = 50;
    QVERIFY_EXCEPTION_THROWN(matchDisparity(image, image, odd), Error);
  }
};

BOOMWATCH_TEST(TestStereoMatcher)
#include "test_stereo_stage.moc"
