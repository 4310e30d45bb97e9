#pragma once

#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "tracking/detection.h"
#include "tracking/scan_levels.h"
#include "tracking/tool_classifier.h"

namespace boomwatch {

/// P-N learning (Kalal et al., "P-N Learning", CVPR 2010): what lies in the box is the tool, and
/// what looks like it elsewhere in the same image is not.
class ToolLearning {
 public:
  /// All that one image and one box can teach. Throws Error when all is equal in `box`.
  ToolClassifier begin(const cv::Mat& grey, const cv::Rect2d& box);

  /// Whether what lies in the box is still enough like the tool to be learnt.
  static bool canLearn(const cv::Mat& grey, const cv::Rect2d& box, const ToolClassifier& tool);
  void learn(const cv::Mat& grey, const cv::Rect2d& box, const ScanLevels& levels,
             const std::vector<Candidate>& candidates, ToolClassifier& tool);

 private:
  void learnPositives(const cv::Mat& grey, const cv::Rect2d& box, int warps, double angle,
                      ToolClassifier& tool);
  double within(double limit);

  std::mt19937 m_random{1};  ///< always the same numbers: results can be repeated
};

}  // namespace boomwatch
