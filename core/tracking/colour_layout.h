#pragma once

#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace boomwatch {

/// How the colours of the tool lie, seen coarsely: eight cells on the longer side of its box.
///
/// A grapple that turns shows other stripes and edges, and patches and keypoints do not know it any
/// more; that it is red above and dark yellow below is seen from every side. How much this tells
/// depends on what else is in the picture. So it watches, while somebody else is sure where the
/// tool is, whether the tool is the place most alike and how alike the others are, and says nothing
/// where it would have been wrong. Of a grey picture it knows light and dark only, and seldom
/// speaks.
///
/// Images are CV_8UC1 or CV_8UC3 (BGR), boxes in their pixels. Used by one thread.
class ColourLayout {
 public:
  struct Place {
    cv::Rect2d box;
    double score = -1.0;  ///< correlation with the view most alike, in Lab: -1..1
  };

  /// Begins anew with what is in `box`.
  void begin(const cv::Mat& image, const cv::Rect2d& box);
  bool isKnown() const { return !m_views.empty(); }

  /// The places most alike, best first, at most eight, none of them half on another. Sizes
  /// from half to twice that at which the tool was last observed are looked at. Empty before it
  /// began, and where the image is too small.
  std::vector<Place> places(const cv::Mat& image) const;
  /// Of one box; -1 where it is outside or nothing is known.
  double scoreOf(const cv::Mat& image, const cv::Rect2d& box) const;

  /// Learns from what places() says of an image in which the tool surely is in `box`: how far that
  /// can be believed, and what the tool looks like from another side.
  void observe(const cv::Mat& image, const std::vector<Place>& places, const cv::Rect2d& box);
  /// Score from which a place is the tool: more than anything else had of late, and half of the
  /// best there can be. Absent where the tool was not the place most alike, or too few images were
  /// observed.
  std::optional<double> threshold() const;
  /// Whether what is in `box` is not even half as much like the tool as it would have to be.
  bool denies(const cv::Mat& image, const cv::Rect2d& box) const;
  /// The first of the `places` of `image`, where exactly it is most alike, if it reaches
  /// threshold() and is clearly more alike than the second.
  std::optional<Place> toolIn(const cv::Mat& image, const std::vector<Place>& places) const;

 private:
  Place refined(const cv::Mat& image, const Place& place) const;

  struct Observation {
    double own = -1.0;    ///< the tool's score
    double other = -1.0;  ///< the best elsewhere
  };

  cv::Size m_cells;
  std::vector<cv::Mat> m_views;  ///< CV_32FC3, Lab, m_cells each, mean 0 and length 1
  cv::Size2d m_size;             ///< of the tool when it was last observed
  std::deque<Observation> m_observed;
};

}  // namespace boomwatch
