#pragma once

#include <memory>
#include <opencv2/core.hpp>

#include "frame/cloud.h"
#include "frame/stereo_rig.h"
#include "parameters/parameters.h"
#include "stereo/disparity_smoother.h"
#include "stereo/row_alignment.h"

namespace boomwatch {

/// A pair whose rows belong together.
struct RectifiedPair {
  cv::Mat left;   ///< CV_8UC1 or CV_8UC3
  cv::Mat right;  ///< CV_8UC1
};

/// A rectified left image, its disparities and its organised cloud.
struct StereoResult {
  cv::Mat left;                        ///< CV_8UC1 or CV_8UC3, rectified
  cv::Mat disparity;                   ///< CV_32FC1, pixels; NaN where nothing matched
  std::shared_ptr<const Cloud> cloud;  ///< with the camera of the rectified pair, and its noise
  /// The cloud without veils (see withoutFlyingPixels): what is in it is a surface, but the rims of
  /// round things are gone.
  std::shared_ptr<const Cloud> surfaces;
  /// How far the rows of left and right differ by the calibration, pixels, by features of the first
  /// frames; absent until those are seen, and where they show too little. See maxRowResidue.
  std::optional<double> rowResidue;
  /// What is left of it, where the right camera is corrected.
  std::optional<double> rowsCorrected;
};

/// Disparities of a rectified pair, CV_32FC1, NaN where nothing matched.
cv::Mat matchDisparity(const cv::Mat& left, const cv::Mat& right,
                       const StereoParameters& parameters);

/// Rectify, match, check left against right, drop speckles, smooth where asked to, reproject
/// (docs/method.md section 2, Eq. 5).
///
/// Keeps the rectification maps between frames; they are made anew when the rig changes. The first
/// frames of a rig show how far its rows differ; with `refine` the right camera is corrected from
/// then on so that they do not (see RowFit). With `average` above 1 it also keeps the mean
/// disparities of the last frames. Used by one thread.
class StereoStage {
 public:
  StereoStage();
  ~StereoStage();

  /// `left` and `right`: CV_8UC1 or CV_8UC3, equal size. Throws Error when the pair does not fit
  /// the rig or the parameters cannot be used.
  StereoResult process(const cv::Mat& left, const cv::Mat& right, const StereoRig& rig,
                       const StereoParameters& parameters) {
    const RectifiedPair pair = rectify(left, right, rig, parameters);
    return reconstruct(pair, matchDisparity(pair.left, pair.right, parameters), parameters);
  }

  /// The first part of process(): whoever needs only the picture need not wait for the rest.
  RectifiedPair rectify(const cv::Mat& left, const cv::Mat& right, const StereoRig& rig,
                        const StereoParameters& parameters);
  /// The last part, of what rectify() gave last, and matchDisparity() of that: CV_32FC1, as large.
  StereoResult reconstruct(const RectifiedPair& pair, const cv::Mat& matched,
                           const StereoParameters& parameters);

 private:
  struct Maps;
  std::unique_ptr<Maps> m_maps;
  RowAlignment m_rows;
  bool m_refined = false;  ///< whether the last pair was turned by what m_rows found
  DisparitySmoother m_smoother;
};

}  // namespace boomwatch
