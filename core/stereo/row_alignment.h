#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace boomwatch {

/// Above so many pixels between the rows of left and right a calibration does not fit its cameras.
inline constexpr double maxRowResidue = 0.5;

/// A feature in both pictures of a rectified pair, pixels. Rectified means left.y == right.y.
struct RowMatch {
  cv::Point2d left, right;
};

/// Corners of the left picture, found again in the right one by optical flow that begins at their
/// disparity; those that do not lead back are left out. `left` and `right`: CV_8UC1, rectified;
/// `disparity`: CV_32FC1, NaN where there is none.
std::vector<RowMatch> matchRows(const cv::Mat& left, const cv::Mat& right,
                                const cv::Mat& disparity);

/// How far the rows of a rectified pair differ, and what takes most of it away: a small turn of the
/// right camera about its x axis (the rows shift) and its z axis (they tilt), and its focal length
/// (they spread), as far from the calibration's as is likely. A turn about y is left alone: the
/// rows hardly show it, and depth depends on it.
struct RowFit {
  double residue = 0.0;                   ///< median of |right.y - left.y|, pixels
  double remaining = 0.0;                 ///< what is left of it then
  cv::Matx33d turn = cv::Matx33d::eye();  ///< right rectified ray -> where it should be
  double focal = 1.0;  ///< how much longer the right focal length is than by the calibration

  /// Whether this is to be believed: it takes away more than features are uncertain by, and the
  /// turn is no more than a degree, beyond which something else is wrong than a camera that has
  /// moved.
  bool worthwhile() const;
};

/// By least squares, far-off matches weighted down. `camera`: the right rectified camera's matrix.
/// Absent when there are too few matches to tell.
std::optional<RowFit> fitRows(const std::vector<RowMatch>& matches, const cv::Matx33d& camera);

/// Gathers the matches of the first frames of a rig and fits them once. Used by one thread.
class RowAlignment {
 public:
  /// A frame as it is rectified without any turn. After the fit this does nothing.
  void look(const cv::Mat& left, const cv::Mat& right, const cv::Mat& disparity,
            const cv::Matx33d& camera);
  /// Whether it needs no more frames.
  bool done() const { return m_frames >= frames; }
  /// Absent until done, and where the frames showed too little.
  const std::optional<RowFit>& fit() const { return m_fit; }

  static constexpr int frames = 10;  ///< so many are looked at

 private:
  int m_frames = 0;
  std::vector<RowMatch> m_matches;
  std::optional<RowFit> m_fit;
};

}  // namespace boomwatch
