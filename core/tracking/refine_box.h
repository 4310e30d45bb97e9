#pragma once

#include <opencv2/core.hpp>

#include "tracking/tool_classifier.h"

namespace boomwatch {

/// Shifts and scales `box` by small steps towards where `grey` (CV_8UC1) looks most like the older
/// patches of the tool, `share` (0..1) of the way. Scanning windows lie a tenth of their size
/// apart; this puts the box between them. Unchanged where nothing looks like the tool.
cv::Rect2d refineBox(const cv::Mat& grey, const cv::Rect2d& box, const ToolClassifier& tool,
                     double share);

}  // namespace boomwatch
