#include <QtTest>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "frame/stereo_rig.h"
#include "simulation/yard/yard_sensor.h"
#include "simulation/yard/yard_source.h"
#include "support/camera_check.h"
#include "support/compare_near.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"
#include "support/yard_frames.h"

using namespace boomwatch;

namespace {

bool sameCloud(const Cloud& a, const Cloud& b) {
  return a.size() == b.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.size() * sizeof(Eigen::Vector3f)) == 0;
}

double meanOf(const cv::Mat& picture) {
  const cv::Scalar mean = cv::mean(picture);
  return (mean[0] + mean[1] + mean[2]) / 3.0;
}

/// Of the grey levels, along both axes.
double sharpness(const cv::Mat& picture, const cv::Mat& mask) {
  cv::Mat grey, edges;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  cv::Laplacian(grey, edges, CV_32F);
  return cv::mean(cv::abs(edges), mask)[0];
}

}  // namespace

class TestYardSource : public QObject {
  Q_OBJECT

  YardFrames m_frames;

  /// One and the same picture as a sensor with these options takes it.
  cv::Mat taken(const std::string& options, std::size_t frame = 0, std::size_t side = 0) {
    cv::Mat picture = m_frames.at("as=cloud", 60)->left.clone();
    YardEye eye;
    eye.eye.x() = side == 0 ? 0.0 : 0.24;
    YardSensor(parseYardOptions(options, "demo:yard")).expose(picture, eye, frame);
    return picture;
  }

 private slots:
  void aStereoFrameCarriesEverything() {
    const auto source = std::make_unique<YardSource>("frames=40", "demo:yard,frames=40");
    QCOMPARE(source->info().frameCount, std::optional<std::size_t>(40));
    QCOMPARE(source->info().nominalRate, 20.0);
    QVERIFY(!source->info().live);
    QVERIFY(source->seek(39) && !source->seek(40));
    const FramePtr frame = source->next({}).frame;
    QCOMPARE(frame->sequence, std::uint64_t(39));
    QCOMPARE(frame->stamp, 39 / 20.0);
    QCOMPARE(frame->left.size(), cv::Size(768, 576));
    QCOMPARE(frame->left.type(), CV_8UC3);
    QCOMPARE(frame->right.size(), frame->left.size());
    QVERIFY(frame->rig && frame->rig->rectified && !frame->cloud);
    QVERIFY(frame->load && frame->trueDistance);
    const YardFrame again = source->at(39);
    QVERIFY(again.truth && samePicture(again.frame->left, frame->left));
    QVERIFY(source->next({}).status == ReadResult::Status::End);
  }

  // Any frame alone, in any order, from a yard of any length: the same bytes.
  void theSameOptionsGiveTheSameBytes() {
    const std::string options = "as=cloud,depth_noise=0.1,exposure=0.5,rain=0.2,path=random";
    const YardFrame shown = m_frames.withTruth(options, 37);
    const FramePtr& sought = shown.frame;
    const auto other = std::make_unique<YardSource>("frames=60," + options);
    QVERIFY(other->seek(36));
    other->next({});
    const FramePtr stepped = other->next({}).frame;
    QVERIFY(samePicture(sought->left, stepped->left));
    QVERIFY(sameCloud(*sought->cloud, *stepped->cloud));
    QVERIFY(samePicture(shown.truth->kind, other->at(37).truth->kind));
    QCOMPARE(sought->trueDistance, stepped->trueDistance);
    QVERIFY(!samePicture(sought->left, m_frames.at(options, 38)->left));
  }

  void anotherSeedIsAnotherYard() {
    const FramePtr one = m_frames.at("as=cloud", 0), two = m_frames.at("as=cloud,seed=2", 0);
    QVERIFY(!sameCloud(*one->cloud, *two->cloud));
    QVERIFY(one->load->centre != two->load->centre);
  }

  void theCloudIsTheDepthThatIsTrue() {
    const auto [frame, truth] = m_frames.withTruth("as=cloud", 120);
    const cv::Mat& depth = truth->depth;
    QVERIFY(frame->cloud->organised() && frame->right.empty() && !frame->rig);
    QCOMPARE(frame->cloud->size(), frame->left.total());
    QCOMPARE(*frame->cloud->camera, demoCamera);
    QVERIFY(missOfCamera(*frame->cloud) < 1e-3);
    for (int v = 0; v < depth.rows; v += 3) {
      for (int u = 0; u < depth.cols; u += 3) {
        const Eigen::Vector3f& p = frame->cloud->at(u, v);
        const float z = depth.at<float>(v, u);
        QCOMPARE(isMeasured(p), bool(std::isfinite(z)));
        if (isMeasured(p)) QVERIFY((p.cast<double>() - z * demoCamera.ray(u, v)).norm() < 1e-4);
      }
    }
  }

  // A fifth of a pixel of disparity: 5 cm at 6 m, four times as much at twice the distance.
  void depthHasTheNoiseOfAStereoCamera() {
    const YardFrame shown = m_frames.withTruth("as=depth", 120);
    const FramePtr& frame = shown.frame;
    const YardTruth& truth = *shown.truth;
    double squares = 0.0;
    int count = 0;
    for (int v = 0; v < truth.depth.rows; ++v) {
      for (int u = 0; u < truth.depth.cols; ++u) {
        const double z = double(truth.depth.at<float>(v, u));
        const Eigen::Vector3f& p = frame->cloud->at(u, v);
        if (!std::isfinite(z) || !isMeasured(p)) continue;
        const double error = truth.depthTimesDisparity * (1.0 / double(p.z()) - 1.0 / z);
        squares += error * error;
        ++count;
        BW_COMPARE_NEAR(double(p.z()) * 1000.0, std::round(double(p.z()) * 1000.0), 0.01);
      }
    }
    const double deviation = std::sqrt(squares / count);
    BW_COMPARE_NEAR(deviation, 0.2, 0.01);
  }

  void noiseIsAsStrongAsItIsSaidToBe() {
    cv::Mat clean, noisy;
    taken("noise=0").convertTo(clean, CV_32F);
    taken("noise=6").convertTo(noisy, CV_32F);
    cv::Scalar mean, deviation;
    // Far from black and white, where noise is cut off.
    const cv::Mat difference = noisy - clean, middle = clean.reshape(1);
    cv::meanStdDev(difference.reshape(1), mean, deviation, (middle > 60) & (middle < 190));
    BW_COMPARE_NEAR(deviation[0], 6.0, 0.3);
    BW_COMPARE_NEAR(mean[0], 0.0, 0.1);
    QVERIFY(!samePicture(taken("noise=6", 1), taken("noise=6", 2)));
  }

  void exposureSwingsToBothSides() {
    const double before = meanOf(taken("noise=0"));
    double darkest = 1e9, brightest = 0.0;
    for (std::size_t k = 0; k < 180; k += 4) {
      const double mean = meanOf(taken("noise=0,exposure=1", k));
      darkest = std::min(darkest, mean);
      brightest = std::max(brightest, mean);
    }
    // Half, and double but for what is white already.
    QVERIFY2(darkest > 0.48 * before && darkest < 0.7 * before,
             qPrintable(QString::number(darkest)));
    QVERIFY2(brightest > 1.4 * before && brightest < 2.0 * before,
             qPrintable(QString::number(brightest)));
  }

  void rainFallsBeforeBothEyes() {
    const cv::Mat dry = taken("noise=0");
    for (const std::size_t eye : {0U, 1U}) {
      cv::Mat changed;
      cv::absdiff(dry, taken("noise=0,rain=1", 60, eye), changed);
      cv::cvtColor(changed, changed, cv::COLOR_BGR2GRAY);
      QVERIFY(cv::countNonZero(changed > 10) > int(changed.total()) / 10);
    }
    // Drops are near: the right eye sees them elsewhere.
    QVERIFY(!samePicture(taken("noise=0,rain=1", 60, 0), taken("noise=0,rain=1", 60, 1)));
  }

  void motionBlursWhatMovesAndNothingElse() {
    const std::string steady = "as=cloud", blurred = "as=cloud,blur=1";
    // The frame, among some, in which the load moves fastest.
    std::size_t fastest = 0;
    double speed = 0.0;
    for (std::size_t k = 0; k < 200; k += 20) {
      const double moved =
          (m_frames.at(steady, k + 1)->load->centre - m_frames.at(steady, k)->load->centre).norm();
      if (moved > speed) speed = moved, fastest = k;
    }
    const auto [a, truthOfA] = m_frames.withTruth(steady, fastest);
    const auto [b, truthOfB] = m_frames.withTruth(blurred, fastest);
    const YardTruth& truth = *truthOfA;
    const cv::Mat tool = truth.kind == double(YardKind::Tool);
    QVERIFY(sharpness(b->left, tool) < 0.8 * sharpness(a->left, tool));
    cv::Mat far, changed;
    cv::absdiff(a->left, b->left, changed);
    cv::inRange(changed, cv::Scalar::all(0), cv::Scalar::all(12), far);
    QVERIFY(cv::countNonZero(far) > int(far.total()) * 3 / 4);
    QVERIFY(samePicture(truth.kind, truthOfB->kind));
  }

  void personAndClutterCanBeLeftOut() {
    const auto kinds = [&](const std::string& options) {
      const YardFrame shown = m_frames.withTruth(options, 100);
      const auto count = [&](YardKind kind) {
        return cv::countNonZero(shown.truth->kind == double(kind));
      };
      return std::array{count(YardKind::Person), count(YardKind::Branch) + count(YardKind::Leaf)};
    };
    const auto all = kinds("as=cloud"), none = kinds("as=cloud,person=off,clutter=off");
    QVERIFY(all[0] > 200 && all[1] > 200);
    QVERIFY(none[0] == 0 && none[1] == 0);
    QVERIFY(!m_frames.withTruth("as=cloud,person=off,clutter=off", 100).truth->person);
  }

  void whatCannotBeIsRefused_data() {
    QTest::addColumn<QString>("options");
    QTest::addColumn<QString>("named");
    const auto row = [](const char* options, const char* named) {
      QTest::newRow(options) << options << named;
    };
    row("sed=7", "'sed'");
    row("seed", "seed");
    row("seed=-1", "0..999999");
    row("seed=1000000", "0..999999");
    row("seed=1.5", "whole");
    row("frames=0", "1..12000");
    row("frames=99999999999999999999", "1..12000");
    row("noise=nan", "0..30");
    row("noise=31", "0..30");
    row("exposure=inf", "0..3");
    row("blur=1.1", "0..1");
    row("rain=2", "0..1");
    row("rain=", "0..1");
    row("depth_noise=x", "0..5");
    row("as=mesh", "stereo|depth|cloud");
    row("path=straight", "scripted|random");
    row("person=maybe", "off|on");
    row("seed=1,seed=2", "twice");
    row("seed=1,,rain=0", "''");
  }
  void whatCannotBeIsRefused() {
    QFETCH(QString, options);
    QFETCH(QString, named);
    const std::string address = "demo:yard," + options.toStdString();
    const QString message = errorOf([&] { YardSource(options.toStdString(), address); });
    COMPARE_CONTAINS(message, QString::fromStdString(address));
    COMPARE_CONTAINS(message, named);
  }
};

BOOMWATCH_TEST(TestYardSource)
#include "test_yard_source.moc"
