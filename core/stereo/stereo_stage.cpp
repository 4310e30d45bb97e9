#include "stereo/stereo_stage.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "base/error.h"
#include "base/size_text.h"
#include "stereo/flying_pixels.h"
#include "stereo/matcher_settings.h"

namespace boomwatch {
namespace {

// OpenCV's matchers give disparities in sixteenths of a pixel.
constexpr int subpixels = 16;

void require(bool condition, const std::string& where, const std::string& what,
             const std::string& remedy) {
  if (!condition) throw Error(where, what, remedy);
}

void checkImages(const cv::Mat& left, const cv::Mat& right) {
  const std::string fix = "Give two images of one camera pair.";
  for (const cv::Mat* image : {&left, &right}) {
    require(image->type() == CV_8UC1 || image->type() == CV_8UC3, "stereo pair",
            "an image is not 8-bit grey or BGR", fix);
  }
  require(!left.empty() && left.size() == right.size(), "stereo pair",
          "left is " + sizeText(left.size()) + " and right is " + sizeText(right.size()), fix);
}

cv::Mat grey(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat result;
  cv::cvtColor(image, result, cv::COLOR_BGR2GRAY);
  return result;
}

cv::Ptr<cv::StereoMatcher> makeMatcher(const StereoParameters& p) {
  if (p.matcher == StereoMatcherKind::Bm) {
    auto bm = cv::StereoBM::create(p.disparities, p.blockSize);
    bm->setPreFilterCap(p.preFilterCap);
    bm->setUniquenessRatio(p.uniqueness);
    // Unlike SGBM, BM takes the range in sixteenths of a pixel.
    bm->setSpeckleRange(p.speckleRange * subpixels);
    bm->setMinDisparity(p.minDisparity);
    bm->setSpeckleWindowSize(p.speckleWindow);
    bm->setDisp12MaxDiff(p.consistency);
    return bm;
  }
  // Smoothness penalties as OpenCV's documentation proposes for one channel.
  const int area = p.blockSize * p.blockSize;
  return cv::StereoSGBM::create(p.minDisparity, p.disparities, p.blockSize, 8 * area, 32 * area,
                                p.consistency, p.preFilterCap, p.uniqueness, p.speckleWindow,
                                p.speckleRange, cv::StereoSGBM::MODE_SGBM_3WAY);
}

// True where there is too little structure for a match to mean anything. Without it the matchers
// invent depth where the picture is over-exposed, unlit or blank.
cv::Mat withoutTexture(const cv::Mat& left, const StereoParameters& p) {
  cv::Mat gradient, mean;
  cv::Sobel(left, gradient, CV_16S, 1, 0, 3);  // 8 times the gradient a pixel
  const int side = 2 * p.blockSize + 1;
  cv::boxFilter(cv::abs(gradient), mean, CV_32F, {side, side});
  return mean < 8.0 * p.texture;
}

// The columns in which the whole search range lies inside the other image.
bool leavesRoom(cv::Size size, const StereoParameters& p) {
  const int searched = p.disparities + std::abs(p.minDisparity) + p.blockSize;
  return size.width > searched && size.height > p.blockSize;
}

}  // namespace

cv::Mat matchDisparity(const cv::Mat& left, const cv::Mat& right,
                       const StereoParameters& parameters) {
  requireMatcherSettings(parameters);
  checkImages(left, right);
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  cv::Mat disparity(left.size(), CV_32FC1, cv::Scalar(none));
  if (!leavesRoom(left.size(), parameters)) return disparity;
  cv::Mat fixedPoint;
  const cv::Mat leftGrey = grey(left);
  try {
    makeMatcher(parameters)->compute(leftGrey, grey(right), fixedPoint);
  } catch (const cv::Exception& fault) {
    throw Error("stereo matcher", "OpenCV refuses the pair or the settings (" + fault.err + ")",
                "Change the stereo parameters.");
  }
  const int first = parameters.minDisparity * subpixels;
  for (int row = 0; row < disparity.rows; ++row) {
    const auto* from = fixedPoint.ptr<std::int16_t>(row);
    auto* to = disparity.ptr<float>(row);
    for (int column = 0; column < disparity.cols; ++column) {
      to[column] = from[column] >= first ? static_cast<float>(from[column]) / subpixels : none;
    }
  }
  if (parameters.texture > 0.0) disparity.setTo(none, withoutTexture(leftGrey, parameters));
  return disparity;
}

namespace {

// A rectified pair, as Eq. 5 uses it. `doffs`: cx of the right less cx of the left, pixels.
struct Projection {
  PinholeCamera camera;  // the left one
  double doffs = 0, baseline = 0;
};

// Eq. 5 with differing principal points: z = B f / (d + doffs). A disparity that puts the point at
// infinity or beyond, and NaN, both fail the comparison.
std::shared_ptr<const Cloud> reproject(const cv::Mat& disparity, const Projection& p) {
  auto cloud = std::make_shared<Cloud>();
  cloud->width = disparity.cols;
  cloud->height = disparity.rows;
  cloud->points.resize(disparity.total());
  const PinholeCamera& camera = p.camera;
  cloud->camera = camera;
  cloud->noise = DepthNoise::ofStereo(camera.fx, p.baseline);
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const auto doffs = static_cast<float>(p.doffs), cx = static_cast<float>(camera.cx);
  const auto bf = static_cast<float>(p.baseline * camera.fx);
  const auto perFx = static_cast<float>(1 / camera.fx);
  Eigen::Vector3f* point = cloud->points.data();
  for (int row = 0; row < disparity.rows; ++row) {
    const auto* d = disparity.ptr<float>(row);
    const auto yOfZ = static_cast<float>((row - camera.cy) / camera.fy);
    for (int column = 0; column < disparity.cols; ++column, ++point) {
      const float shifted = d[column] + doffs;
      const float z = shifted > 0 ? bf / shifted : none;
      *point = {(static_cast<float>(column) - cx) * perFx * z, yOfZ * z, z};
    }
  }
  return cloud;
}

cv::Mat remapped(const cv::Mat& image, const cv::Mat& xy, const cv::Mat& weights) {
  if (xy.empty()) return image;
  cv::Mat result;
  cv::remap(image, result, xy, weights, cv::INTER_LINEAR);
  return result;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && (a.empty() || cv::norm(a, b, cv::NORM_INF) == 0);
}

bool same(const StereoRig& a, const StereoRig& b) {
  return a.imageSize == b.imageSize && a.leftMatrix == b.leftMatrix &&
         a.rightMatrix == b.rightMatrix && same(a.leftDistortion, b.leftDistortion) &&
         same(a.rightDistortion, b.rightDistortion) && a.rotation == b.rotation &&
         a.translation == b.translation && a.rectified == b.rectified;
}

}  // namespace

struct StereoStage::Maps {
  StereoRig rig;
  cv::Size size;
  cv::Mat leftXy, leftWeights;    // empty when the rig is rectified
  cv::Mat rightXy, rightWeights;  // empty when, besides, the right camera is not turned
  Projection projection;
  cv::Matx33d rightRotation = cv::Matx33d::eye();  // of the rectification
  cv::Matx33d rightCamera;                         // rectified
  cv::Matx33d turn = cv::Matx33d::eye();           // of the right camera, on top of it
  double focal = 1.0;                              // of the right camera, times what it should be

  Maps(const StereoRig& from, cv::Size imageSize) : rig(from), size(imageSize) {
    // The caller may go on to write into its matrices.
    rig.leftDistortion = from.leftDistortion.clone();
    rig.rightDistortion = from.rightDistortion.clone();
    if (rig.rectified) {
      const auto& left = rig.leftMatrix;
      projection = {{size.width, size.height, left(0, 0), left(1, 1), left(0, 2), left(1, 2)},
                    rig.rightMatrix(0, 2) - left(0, 2),
                    rig.baseline()};
      rightCamera = rig.rightMatrix;
    } else {
      rectify();
    }
    const auto& [camera, doffs, baseline] = projection;
    require(std::isfinite(camera.fx) && camera.fx > 0 && std::isfinite(camera.fy) &&
                camera.fy > 0 && std::isfinite(baseline) && baseline > 0 &&
                std::isfinite(camera.cx) && std::isfinite(camera.cy) && std::isfinite(doffs),
            "stereo calibration", "it cannot be rectified", "Calibrate anew.");
  }

  bool fits(const StereoRig& other, cv::Size imageSize) const {
    return size == imageSize && same(rig, other);
  }

  // Turns the right camera, puts its focal length right, and says whether that changed anything.
  bool correctRight(const RowFit& fit) {
    if (turn == fit.turn && focal == fit.focal) return false;
    turn = fit.turn;
    focal = fit.focal;
    mapRight();
    return true;
  }

 private:
  void mapRight() {
    if (rig.rectified && turn == cv::Matx33d::eye() &&
        focal == 1.0) {  // remapping would only blur it
      rightXy = rightWeights = cv::Mat();
      return;
    }
    cv::Matx33d camera = rightCamera;
    camera(0, 0) /= focal;
    camera(1, 1) /= focal;
    cv::initUndistortRectifyMap(rig.rightMatrix, rig.rightDistortion, turn * rightRotation, camera,
                                size, CV_16SC2, rightXy, rightWeights);
  }

  void rectify() {
    cv::Mat r1, r2, q;
    cv::Matx34d p1, p2;
    const auto& [m1, m2] = std::tie(rig.leftMatrix, rig.rightMatrix);
    try {
      cv::stereoRectify(m1, rig.leftDistortion, m2, rig.rightDistortion, size, rig.rotation,
                        rig.translation, r1, r2, p1, p2, q, cv::CALIB_ZERO_DISPARITY, 0);
      cv::initUndistortRectifyMap(m1, rig.leftDistortion, r1, p1, size, CV_16SC2, leftXy,
                                  leftWeights);
      rightRotation = r2;
      rightCamera = p2.get_minor<3, 3>(0, 0);
      mapRight();
    } catch (const cv::Exception& fault) {
      throw Error("stereo calibration", "OpenCV cannot rectify with it (" + fault.err + ")",
                  "Calibrate anew.");
    }
    // P2 = K [I | (-B, 0, 0)].
    projection = {{size.width, size.height, p1(0, 0), p1(1, 1), p1(0, 2), p1(1, 2)},
                  p2(0, 2) - p1(0, 2),
                  -p2(0, 3) / p2(0, 0)};
  }
};

StereoStage::StereoStage() = default;
StereoStage::~StereoStage() = default;

RectifiedPair StereoStage::rectify(const cv::Mat& left, const cv::Mat& right, const StereoRig& rig,
                                   const StereoParameters& parameters) {
  checkImages(left, right);
  require(
      rig.imageSize.empty() || rig.imageSize == left.size(), "stereo calibration",
      "it is for images of " + sizeText(rig.imageSize) + ", but these are " + sizeText(left.size()),
      "Give the calibration of this recording.");
  if (!m_maps || !m_maps->fits(rig, left.size())) {
    m_maps = std::make_unique<Maps>(rig, left.size());
    m_rows = RowAlignment();
    m_smoother.reset();
  }
  const auto& fit = m_rows.fit();
  m_refined = parameters.refine && fit && fit->worthwhile();
  if (m_maps->correctRight(m_refined ? *fit : RowFit{})) m_smoother.reset();
  return {remapped(left, m_maps->leftXy, m_maps->leftWeights),
          remapped(grey(right), m_maps->rightXy, m_maps->rightWeights)};
}

StereoResult StereoStage::reconstruct(const RectifiedPair& pair, const cv::Mat& matched,
                                      const StereoParameters& parameters) {
  StereoResult result;
  const auto& fit = m_rows.fit();
  if (fit) result.rowResidue = fit->residue;
  if (m_refined) result.rowsCorrected = fit->remaining;
  result.left = pair.left;
  m_rows.look(grey(pair.left), pair.right, matched, m_maps->rightCamera);
  result.disparity = DisparitySmoother::overSpace(m_smoother.overTime(matched, parameters.average),
                                                  parameters.smooth);
  result.cloud = result.surfaces = reproject(result.disparity, m_maps->projection);
  if (parameters.maxSlope > 0.0) {
    const double focalLength = m_maps->projection.camera.fx;
    result.surfaces =
        reproject(withoutFlyingPixels(result.disparity, parameters.maxSlope, focalLength),
                  m_maps->projection);
  }
  return result;
}

}  // namespace boomwatch
