#include <QtTest>
#include <cmath>
#include <limits>

#include "stereo/disparity_smoother.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

cv::Mat constant(float disparity) { return cv::Mat(20, 30, CV_32FC1, cv::Scalar(disparity)); }

cv::Mat noisy(float disparity, float deviation, cv::RNG& random) {
  cv::Mat noise(60, 80, CV_32FC1);
  random.fill(noise, cv::RNG::NORMAL, disparity, deviation);
  return noise;
}

double deviationOf(const cv::Mat& disparity) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(disparity, mean, deviation, disparity == disparity);
  return deviation[0];
}

}  // namespace

class TestDisparitySmoother : public QObject {
  Q_OBJECT
 private slots:
  void offChangesNothing();
  void runningMeanTakesOutNoise();
  void whatIsNewIsSeenOnceItHasSettled();
  void whatIsClearlyNearerIsSeenAtOnce();
  void missedFrameBeginsAnew();
  void neighboursTakeOutNoiseButKeepEdges();
  void whatIsLikeNothingAroundItIsNoise();
  void unmeasuredStaysUnmeasured();
  void newSizeForgets();
  void whatWasNotMatchedForLongIsSeenAtOnce();
  void besideAStillSurfaceSmallStepsWait();
  void whatMovesOverTheUnmatchedIsSeenAtOnce();
};

void TestDisparitySmoother::offChangesNothing() {
  cv::RNG random(1);
  const cv::Mat disparity = noisy(25.0F, 1.0F, random);
  DisparitySmoother smoother;
  QCOMPARE(cv::norm(smoother.overTime(disparity, 1), disparity, cv::NORM_INF), 0.0);
  QCOMPARE(cv::norm(DisparitySmoother::overSpace(disparity, 0), disparity, cv::NORM_INF), 0.0);
}

void TestDisparitySmoother::runningMeanTakesOutNoise() {
  cv::RNG random(2);
  DisparitySmoother smoother;
  cv::Mat mean;
  for (int frame = 0; frame < 200; ++frame) mean = smoother.overTime(noisy(25, 0.4F, random), 16);
  // The variance of an exponential mean with weight a is a / (2 - a) of one frame's.
  const double expected = 0.4 * std::sqrt((1.0 / 16) / (2.0 - 1.0 / 16));
  BW_COMPARE_NEAR(deviationOf(mean), expected, 0.1 * expected);
}

void TestDisparitySmoother::whatIsNewIsSeenOnceItHasSettled() {
  DisparitySmoother smoother;
  for (int frame = 0; frame < 50; ++frame) smoother.overTime(constant(25.0F), 20);
  for (int frame = 1; frame < DisparitySmoother::settled; ++frame) {
    QVERIFY(std::isnan(smoother.overTime(constant(30.0F), 20).at<float>(5, 5)));
  }
  QCOMPARE(smoother.overTime(constant(30.0F), 20).at<float>(5, 5), 30.0F);
}

void TestDisparitySmoother::whatIsClearlyNearerIsSeenAtOnce() {
  DisparitySmoother smoother;
  for (int frame = 0; frame < 50; ++frame) smoother.overTime(constant(25.0F), 20);
  QCOMPARE(smoother.overTime(constant(60.0F), 20).at<float>(5, 5), 60.0F);
  // Even where the moment before gave no depth.
  for (int frame = 0; frame < 50; ++frame) smoother.overTime(constant(25.0F), 20);
  smoother.overTime(constant(none), 20);
  QCOMPARE(smoother.overTime(constant(60.0F), 20).at<float>(5, 5), 60.0F);
}

void TestDisparitySmoother::missedFrameBeginsAnew() {
  DisparitySmoother smoother;
  for (int frame = 0; frame < 50; ++frame) smoother.overTime(constant(25.0F), 20);
  QVERIFY(std::isnan(smoother.overTime(constant(none), 20).at<float>(5, 5)));
  QVERIFY(std::isnan(smoother.overTime(constant(26.0F), 20).at<float>(5, 5)));
  for (int frame = 2; frame < DisparitySmoother::settled; ++frame) {
    QVERIFY(std::isnan(smoother.overTime(constant(26.0F), 20).at<float>(5, 5)));
  }
  QCOMPARE(smoother.overTime(constant(26.0F), 20).at<float>(5, 5), 26.0F);
}

void TestDisparitySmoother::neighboursTakeOutNoiseButKeepEdges() {
  cv::RNG random(3);
  cv::Mat step = noisy(20.0F, 0.2F, random);
  step.colRange(40, 80) += 20.0F;
  const cv::Mat smoothed = DisparitySmoother::overSpace(step, 15);
  QVERIFY(deviationOf(smoothed.colRange(0, 40)) < 0.08);
  for (int row = 0; row < step.rows; ++row) {
    BW_COMPARE_NEAR(smoothed.at<float>(row, 39), 20.0F, 0.5F);
    BW_COMPARE_NEAR(smoothed.at<float>(row, 40), 40.0F, 0.5F);
  }
}

void TestDisparitySmoother::whatIsLikeNothingAroundItIsNoise() {
  cv::Mat disparity(100, 100, CV_32FC1, cv::Scalar(25.0F));
  disparity(cv::Rect(20, 30, 4, 3)) = 26.5F;
  disparity(cv::Rect(60, 60, 15, 15)) = 26.5F;  // as large as a block that is matched
  const cv::Mat smoothed = DisparitySmoother::overSpace(disparity, 31);
  QVERIFY(std::isnan(smoothed.at<float>(31, 22)));
  QCOMPARE(smoothed.at<float>(31, 30), 25.0F);
  QCOMPARE(smoothed.at<float>(67, 67), 26.5F);
  QCOMPARE(smoothed.at<float>(61, 61), 26.5F);
  // A small thing that stands out by more than noise stays, and so does a steep slope.
  disparity(cv::Rect(20, 30, 4, 3)) = 28.5F;
  QCOMPARE(DisparitySmoother::overSpace(disparity, 31).at<float>(31, 22), 28.5F);
  for (int column = 0; column < disparity.cols; ++column) {
    disparity.col(column) = 20.0F + 0.9F * static_cast<float>(column);
  }
  const cv::Mat slope = DisparitySmoother::overSpace(disparity, 31);
  QCOMPARE(cv::countNonZero(slope == slope), 100 * 100);
}

void TestDisparitySmoother::unmeasuredStaysUnmeasured() {
  cv::Mat disparity = constant(10.0F);
  disparity.at<float>(7, 9) = none;
  const cv::Mat smoothed = DisparitySmoother::overSpace(disparity, 9);
  QVERIFY(std::isnan(smoothed.at<float>(7, 9)));
  QCOMPARE(smoothed.at<float>(7, 10), 10.0F);
}

void TestDisparitySmoother::newSizeForgets() {
  DisparitySmoother smoother;
  for (int frame = 0; frame < 10; ++frame) smoother.overTime(constant(25.0F), 20);
  const cv::Mat other(9, 9, CV_32FC1, cv::Scalar(20.0F));
  QCOMPARE(smoother.overTime(other, 20).at<float>(4, 4), 20.0F);
}

void TestDisparitySmoother::whatWasNotMatchedForLongIsSeenAtOnce() {
  DisparitySmoother smoother;
  QCOMPARE(smoother.overTime(constant(25.0F), 20).at<float>(5, 5), 25.0F);
  for (int frame = 0; frame < 21; ++frame) smoother.overTime(constant(none), 20);
  QCOMPARE(smoother.overTime(constant(20.0F), 20).at<float>(5, 5), 20.0F);
}

void TestDisparitySmoother::besideAStillSurfaceSmallStepsWait() {
  cv::Mat half(60, 200, CV_32FC1, cv::Scalar(none));
  half.colRange(0, 50) = 25.0F;
  DisparitySmoother smoother;
  for (int frame = 0; frame < 50; ++frame) smoother.overTime(half, 20);
  const auto with = [&half](float disparity) {
    cv::Mat frame = half.clone();
    frame.colRange(50, 60) = disparity;
    frame.colRange(150, 160) = disparity;
    return frame;
  };
  for (int frame = 1; frame < DisparitySmoother::settled; ++frame) {
    const cv::Mat seen = smoother.overTime(with(27.5F), 20);
    QVERIFY(std::isnan(seen.at<float>(30, 55)));
    // Nothing is known there that it could be noise of.
    QCOMPARE(seen.at<float>(30, 155), 27.5F);
  }
  QCOMPARE(smoother.overTime(with(27.5F), 20).at<float>(30, 55), 27.5F);
  smoother.reset();
  for (int frame = 0; frame < 50; ++frame) smoother.overTime(half, 20);
  // A step that is more than noise does not wait.
  QCOMPARE(smoother.overTime(with(28.5F), 20).at<float>(30, 55), 28.5F);
}

void TestDisparitySmoother::whatMovesOverTheUnmatchedIsSeenAtOnce() {
  DisparitySmoother smoother;
  for (int frame = 0; frame < 50; ++frame) {
    smoother.overTime(cv::Mat(60, 300, CV_32FC1, cv::Scalar(none)), 20);
  }
  for (int left = 0; left < 200; left += 8) {
    cv::Mat moved(60, 300, CV_32FC1, cv::Scalar(none));
    moved.colRange(left, left + 40) = 40.0F;
    QCOMPARE(smoother.overTime(moved, 20).at<float>(30, left + 39), 40.0F);
  }
}

BOOMWATCH_TEST(TestDisparitySmoother)
#include "test_disparity_smoother.moc"
