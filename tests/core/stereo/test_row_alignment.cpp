#include <QtTest>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "stereo/stereo_stage.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr double degree = std::numbers::pi / 180.0;
const cv::Size size(640, 480);
const cv::Matx33d camera(600, 0, 320, 0, 600, 240, 0, 0, 1);

/// A slanted floor: the disparity grows down the picture.
double truth(double row) { return 12.0 + 20.0 * row / size.height; }

struct Pair {
  cv::Mat left, right;
};

cv::Mat texture() {
  cv::Mat noise(size, CV_8UC1), soft;
  cv::RNG(5).fill(noise, cv::RNG::UNIFORM, 0, 255);
  cv::GaussianBlur(noise, soft, {}, 1.5);
  cv::normalize(soft, soft, 0, 255, cv::NORM_MINMAX);
  return soft;
}

/// What a right camera that is turned by `turn` sees; a right ray r is seen at turn * r.
Pair pairSeenWith(const cv::Matx33d& turn) {
  cv::Mat x, y;
  cv::initUndistortRectifyMap(camera, {}, turn, camera, size, CV_32FC1, x, y);
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      x.at<float>(row, column) += static_cast<float>(truth(y.at<float>(row, column)));
    }
  }
  Pair pair{texture(), {}};
  cv::remap(pair.left, pair.right, x, y, cv::INTER_CUBIC, cv::BORDER_REFLECT);
  return pair;
}

cv::Matx33d turned(double aboutX, double aboutZ) {
  cv::Matx33d turn;
  cv::Rodrigues(cv::Vec3d(aboutX, 0, aboutZ) * degree, turn);
  return turn;
}

StereoRig rig(bool rectified) {
  StereoRig rig;
  rig.imageSize = size;
  rig.leftMatrix = rig.rightMatrix = camera;
  rig.translation = {-0.1, 0, 0};
  rig.rectified = rectified;
  return rig;
}

StereoParameters with(bool refine) {
  StereoParameters parameters;
  parameters.refine = refine;
  return parameters;
}

/// The result of the frame after those that are looked at.
StereoResult settled(const Pair& pair, const StereoRig& rig, const StereoParameters& parameters) {
  StereoStage stage;
  for (int frame = 0; frame < RowAlignment::frames; ++frame) {
    stage.process(pair.left, pair.right, rig, parameters);
  }
  return stage.process(pair.left, pair.right, rig, parameters);
}

/// Median of |disparity - truth|, right of what the right camera does not see.
double disparityError(const cv::Mat& disparity) {
  std::vector<double> errors;
  for (int row = 20; row < size.height - 20; ++row) {
    for (int column = 100; column < size.width - 20; ++column) {
      const float d = disparity.at<float>(row, column);
      if (std::isfinite(d)) errors.push_back(std::abs(d - truth(row)));
    }
  }
  std::nth_element(errors.begin(), errors.begin() + static_cast<long>(errors.size() / 2),
                   errors.end());
  return errors[errors.size() / 2];
}

bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::countNonZero((a != b) & ((a == a) | (b == b))) == 0;
}

/// Matches all over the picture that a turn of the right camera puts on other rows.
std::vector<RowMatch> matchesWith(const cv::Matx33d& turn, int count, double strays,
                                  double rowsFrom = 10, double rowsTo = 470) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(60, 620), v(rowsFrom, rowsTo), any(-8, 8), share(0, 1);
  std::vector<RowMatch> matches;
  for (int k = 0; k < count; ++k) {
    const cv::Point2d left(u(random), v(random));
    const cv::Vec3d ray = turn * (camera.inv() * cv::Vec3d(left.x - truth(left.y), left.y, 1));
    const cv::Vec3d seen = camera * ray;
    cv::Point2d right(seen[0] / seen[2], seen[1] / seen[2]);
    if (share(random) < strays) right.y += any(random);
    matches.push_back({left, right});
  }
  return matches;
}

}  // namespace

class TestRowAlignment : public QObject {
  Q_OBJECT

 private slots:
  void aTurnOfTheRightCameraIsFoundAmongStrays() {
    const cv::Matx33d turn = turned(0.12, -0.2);
    const auto fit = fitRows(matchesWith(turn, 400, 0.25), camera);
    QVERIFY(fit.has_value() && fit->worthwhile());
    QVERIFY(fit->residue > 1.0 && fit->remaining < 0.05);
    cv::Vec3d rest;
    cv::Rodrigues(fit->turn * turn, rest);
    QVERIFY(cv::norm(rest) < 0.01 * degree);
  }

  void moreThanADegreeIsRefusedAndFewMatchesSayNothing() {
    QVERIFY(fitRows(matchesWith(turned(0, 0.9), 400, 0.0), camera)->worthwhile());
    QVERIFY(!fitRows(matchesWith(turned(0, 1.1), 400, 0.0), camera)->worthwhile());
    QVERIFY(!fitRows(matchesWith(turned(0, 0.01), 400, 0.0), camera)->worthwhile());
    QVERIFY(!fitRows(matchesWith(turned(0, 0.5), 59, 0.0), camera).has_value());
  }

  // A turn about y moves rows as well, the more so in the corners; it is not taken for another.
  void aTurnAboutTheVerticalIsNotTakenForAnother() {
    cv::Matx33d turn;
    cv::Rodrigues(cv::Vec3d(0, 0.6, 0) * degree, turn);
    const auto fit = fitRows(matchesWith(turn, 400, 0.0), camera);
    cv::Vec3d found;
    cv::Rodrigues(fit->turn, found);
    QVERIFY(cv::norm(found) < 0.02 * degree);
  }

  void aLongerFocalLengthIsFoundWhereTheRowsShowIt() {
    const cv::Matx33d longer = cv::Matx33d::diag({1.001, 1.001, 1.0}) * turned(0.08, 0.15);
    BW_COMPARE_NEAR(fitRows(matchesWith(longer, 400, 0.25), camera)->focal, 1.001, 2e-4);
    // A narrow band of rows does not.
    const auto narrow = fitRows(matchesWith(longer, 400, 0.0, 225, 255), camera);
    QVERIFY(narrow->worthwhile());
    BW_COMPARE_NEAR(narrow->focal, 1.0, 2e-4);
  }

  void aMisalignedPairIsSaidAndPutRight_data() { eachRig(); }
  void aMisalignedPairIsSaidAndPutRight() {
    QFETCH(bool, rectified);
    const Pair pair = pairSeenWith(turned(0.08, 0.15));
    const StereoResult plain = settled(pair, rig(rectified), with(false));
    const StereoResult refined = settled(pair, rig(rectified), with(true));
    QVERIFY(plain.rowResidue.value() > 0.6);
    QCOMPARE(refined.rowResidue, plain.rowResidue);
    QVERIFY(!plain.rowsCorrected && refined.rowsCorrected.value() < 0.1);
    // What is left is the matcher's own error, that of a perfect pair.
    const Pair perfect = pairSeenWith(cv::Matx33d::eye());
    const double own = disparityError(settled(perfect, rig(true), with(false)).disparity);
    qInfo("disparities off by %.3f px, refined %.3f px, of a perfect pair %.3f px",
          disparityError(plain.disparity), disparityError(refined.disparity), own);
    QVERIFY(disparityError(refined.disparity) < own + 0.03);
    QVERIFY(disparityError(plain.disparity) > own + 0.1);
  }

  void aPerfectPairStaysAsItIs_data() { eachRig(); }
  void aPerfectPairStaysAsItIs() {
    QFETCH(bool, rectified);
    const Pair pair = pairSeenWith(cv::Matx33d::eye());
    const StereoResult plain = settled(pair, rig(rectified), with(false));
    const StereoResult refined = settled(pair, rig(rectified), with(true));
    QVERIFY(plain.rowResidue.value() < 0.1 && !refined.rowsCorrected);
    QVERIFY(equal(plain.disparity, refined.disparity));
  }

  void blankPicturesSayNothingAndChangeNothing() {
    const cv::Mat blank(size, CV_8UC1, cv::Scalar(128));
    const StereoResult result = settled({blank, blank}, rig(true), with(true));
    QVERIFY(!result.rowResidue.has_value());
    QCOMPARE(cv::countNonZero(result.disparity == result.disparity), 0);
  }

  void switchingItOffBringsTheOldPictureBack() {
    const Pair pair = pairSeenWith(turned(0.08, 0.15));
    StereoStage stage;
    const cv::Mat before = stage.process(pair.left, pair.right, rig(true), with(true)).disparity;
    for (int frame = 0; frame < RowAlignment::frames; ++frame) {
      stage.process(pair.left, pair.right, rig(true), with(true));
    }
    QVERIFY(!equal(stage.process(pair.left, pair.right, rig(true), with(true)).disparity, before));
    QVERIFY(equal(stage.process(pair.left, pair.right, rig(true), with(false)).disparity, before));
  }

 private:
  static void eachRig() {
    QTest::addColumn<bool>("rectified");
    QTest::newRow("rectified") << true;
    QTest::newRow("unrectified") << false;
  }
};

BOOMWATCH_TEST(TestRowAlignment)
#include "test_row_alignment.moc"
