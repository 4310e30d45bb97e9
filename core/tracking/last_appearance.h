#pragma once

#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace boomwatch {

/// Re-detects the tool by its last appearance, a patch of the tool and the rim around it. After a
/// short occlusion this patch matches better than a learnt model, because it shows the tool from
/// the same side and in the same light. Images are CV_8UC1 of any size, boxes in pixels. Not
/// thread-safe.
class LastAppearance {
 public:
  /// Remembers the appearance of the tool in `box`; call it while the tool is tracked with
  /// certainty. Ignores a box that is too small, blank, or more than a tenth outside the picture.
  void remember(const cv::Mat& grey, const cv::Rect2d& box);
  void forget() { *this = {}; }
  /// The tool is tracked again: forgets the search, keeps the appearance.
  void follow() {
    m_recent.clear();
    m_maxLikeness.reset();
    m_last.reset();
  }

  /// Searches the whole image for a lost tool; call it for each image until the tool is tracked
  /// again. Returns the tool's box when two images in a row match at the same place. A match must
  /// be clearly better than any other place in the image, and than any place since the loss. Always
  /// absent in the first images, which show how well other objects match.
  std::optional<cv::Rect2d> find(const cv::Mat& grey);

  /// Whether the image in `box` matches the last appearance of the tool.
  bool recognises(const cv::Mat& grey, const cv::Rect2d& box) const;

 private:
  struct Place {
    cv::Rect2d box;           ///< of the tool, without the rim
    double likeness = -1.0;   ///< correlation, -1..1, of tool and rim
    double second = -1.0;     ///< the best likeness elsewhere in the image
    double toolAlone = -1.0;  ///< correlation, -1..1, of the tool without its rim
  };
  /// An image at one scale, and the correlation of the patch at each place.
  struct Level {
    cv::Mat image, fit;
    double scale;  ///< level pixels per image pixel
  };

  Level levelOf(const cv::Mat& grey, double size) const;
  std::optional<Place> bestOf(const std::vector<Level>& levels) const;
  double toolAlone(const cv::Mat& image, cv::Point at) const;

  cv::Mat m_patch;       ///< tool and rim, scaled down
  cv::Rect2d m_tool;     ///< pixels of the patch; may reach outside it at the edge of the picture
  double m_scale = 1.0;  ///< patch pixels per image pixel
  std::deque<double> m_recent;          ///< best likeness of each of the last images since the loss
  std::optional<double> m_maxLikeness;  ///< maximum of all images before these
  std::optional<Place> m_last;          ///< the match of the image before
};

}  // namespace boomwatch
