#pragma once

#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace boomwatch {

/// What the tool and the rim around it looked like when it was last seen. A learnt model knows what
/// a tool looks like at all; of one that was covered for a moment, the last look tells more, in
/// light and from sides that the model never learnt. Images are CV_8UC1 of any size, boxes in
/// pixels. Not thread-safe.
class LastAppearance {
 public:
  /// The tool is followed, and is in `box` for sure. Nothing is remembered of a box that is too
  /// small, or not wholly in the picture.
  void remember(const cv::Mat& grey, const cv::Rect2d& box);
  void forget() { *this = {}; }
  /// It is followed again: what was seen while it was away does not matter any more.
  void follow() {
    m_lately.clear();
    m_likest.reset();
    m_last.reset();
  }

  /// The tool is lost, and looked for in each image until it is followed again. Where it came
  /// back: a place that looks like it, rim included, clearly more than any other in this image and
  /// more than anything did while it was away, twice in turn. Never in the first images: they show
  /// what else looks like it.
  std::optional<cv::Rect2d> find(const cv::Mat& grey);

  /// Whether what is in `box` looks as the tool did.
  bool recognises(const cv::Mat& grey, const cv::Rect2d& box) const;

 private:
  struct Place {
    cv::Rect2d box;           ///< the tool's
    double likeness = -1.0;   ///< correlation, -1..1, of tool and rim
    double second = -1.0;     ///< the best elsewhere
    double toolAlone = -1.0;  ///< correlation of the tool without its rim
  };
  /// An image at one scale and how well the patch fits at each place of it.
  struct Level {
    cv::Mat image, fit;
    double scale;  ///< pixels of it an image pixel
  };

  Level levelOf(const cv::Mat& grey, double size) const;
  std::optional<Place> bestOf(const std::vector<Level>& levels) const;
  double toolAlone(const cv::Mat& image, cv::Point at) const;

  cv::Mat m_patch;                 ///< tool and rim, as small as still tells them from others
  cv::Rect2d m_tool;               ///< pixels of the patch; reaches outside at the picture's edge
  double m_scale = 1.0;            ///< pixels of the patch an image pixel
  std::deque<double> m_lately;     ///< of the last images without the tool, the best likeness
  std::optional<double> m_likest;  ///< the same of all before these
  std::optional<Place> m_last;
};

}  // namespace boomwatch
