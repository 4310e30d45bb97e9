#pragma once

#include <QDir>
#include <QFileInfo>
#include <QString>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "stereo/calibration.h"
#include "support/numpy_archive.h"
#include "support/real_data.h"

namespace boomwatch::test {

/// A rectified pair with the truth of its disparities.
struct StereoSet {
  QString name;
  cv::Mat left, right;
  cv::Mat truth;  ///< CV_32FC1, pixels; NaN where there is none
  StereoRig rig;
  int disparities = 64;
};

/// Disparities in an image of whole numbers, `scale` a pixel, 0 = none; or a float image, inf =
/// none.
inline cv::Mat readTruth(const QString& file, double scale) {
  cv::Mat stored, truth;
  if (file.endsWith(QLatin1String(".npz"))) {
    stored = readNumpyImage(file);
  } else {
    // Some sets store grey in three channels.
    cv::extractChannel(cv::imread(file.toStdString(), cv::IMREAD_UNCHANGED), stored, 0);
  }
  stored.convertTo(truth, CV_32F, 1.0 / scale);
  for (float& d : cv::Mat_<float>(truth)) {
    if (!(d > 0.0F && d < 1e4F)) d = std::numeric_limits<float>::quiet_NaN();
  }
  return truth;
}

/// A rig for sets that state no calibration: the shape of the scene holds up to scale.
inline StereoRig assumedRig(const cv::Mat& image) {
  StereoRig rig;
  rig.imageSize = image.size();
  rig.rectified = true;
  const double f = image.cols;
  rig.leftMatrix = rig.rightMatrix =
      cv::Matx33d(f, 0, image.cols / 2.0, 0, f, image.rows / 2.0, 0, 0, 1);
  rig.translation = {-0.1, 0, 0};
  return rig;
}

inline void addSet(std::vector<StereoSet>& sets, const QString& name, const QString& left,
                   const QString& right, const QString& truth, double scale, int disparities,
                   const QString& calibration = {}) {
  if (!QFileInfo::exists(left) || !QFileInfo::exists(truth)) return;
  StereoSet set;
  set.name = name;
  set.left = cv::imread(left.toStdString(), cv::IMREAD_COLOR);
  set.right = cv::imread(right.toStdString(), cv::IMREAD_COLOR);
  set.truth = readTruth(truth, scale);
  set.rig =
      calibration.isEmpty() ? assumedRig(set.left) : readCalibration(calibration.toStdString());
  set.disparities = disparities;
  sets.push_back(std::move(set));
}

/// The motorcycle's calibration, which scikit-image publishes beside the pair, at its size.
inline StereoRig motorcycleRig(const cv::Mat& image) {
  StereoRig rig;
  rig.imageSize = image.size();
  rig.rectified = true;
  rig.leftMatrix = cv::Matx33d(994.978, 0, 311.193, 0, 994.978, 254.877, 0, 0, 1);
  rig.rightMatrix = rig.leftMatrix;
  rig.rightMatrix(0, 2) += 31.086;
  rig.translation = {-0.193001, 0, 0};
  return rig;
}

/// Every pair with truth that this machine has: Debian's own and the recordings.
inline std::vector<StereoSet> stereoSetsWithTruth() {
  std::vector<StereoSet> sets;
  const QString debian = QStringLiteral("/usr/share/doc/opencv-doc/examples/data/");
  addSet(sets, QStringLiteral("aloe"), debian + QStringLiteral("aloeL.jpg"),
         debian + QStringLiteral("aloeR.jpg"), debian + QStringLiteral("aloeGT.png"), 1.0, 256);
  const QString eth3d = sharedData(QStringLiteral("stereo_gt_eth3d_outdoor/playground/"));
  addSet(sets, QStringLiteral("playground"), eth3d + QStringLiteral("im0.png"),
         eth3d + QStringLiteral("im1.png"), eth3d + QStringLiteral("disp0.pfm"), 1.0, 64,
         eth3d + QStringLiteral("calib.txt"));
  const QString middlebury =
      sharedData(QStringLiteral("stereo_gt_middlebury/opencv_extra_datasets/"));
  const std::vector<std::pair<QString, double>> scenes{
      {"barn2", 8},    {"bull", 8},  {"poster", 8}, {"sawtooth", 8},
      {"tsukuba", 16}, {"venus", 8}, {"cones", 4},  {"teddy", 4}};
  for (const auto& [scene, scale] : scenes) {
    const QString folder = middlebury + scene + QLatin1Char('/');
    addSet(sets, scene, folder + QStringLiteral("im2.png"), folder + QStringLiteral("im6.png"),
           folder + QStringLiteral("disp2.png"), scale, 64);
  }
  const QString motorcycle =
      sharedData(QStringLiteral("stereo_gt_middlebury/motorcycle/motorcycle_"));
  addSet(sets, QStringLiteral("motorcycle"), motorcycle + QStringLiteral("left.png"),
         motorcycle + QStringLiteral("right.png"), motorcycle + QStringLiteral("disp.npz"), 1.0,
         64);
  if (!sets.empty() && sets.back().name == QLatin1String("motorcycle")) {
    sets.back().rig = motorcycleRig(sets.back().left);
  }
  const QString kitti = sharedData(QStringLiteral("stereo_gt_kitti2012/"));
  const QString calibration =
      sharedData(QStringLiteral("stereo_seq_kitti_odometry/KITTI_sequence_1/calib.txt"));
  for (const QString& file : QDir(kitti + QStringLiteral("image_0")).entryList({"*.png"})) {
    addSet(sets, QStringLiteral("kitti ") + file, kitti + QStringLiteral("image_0/") + file,
           kitti + QStringLiteral("image_1/") + file, kitti + QStringLiteral("disp_noc/") + file,
           256.0, 128, calibration);
  }
  return sets;
}

}  // namespace boomwatch::test
