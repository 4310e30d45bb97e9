#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "frame/cloud.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// The tool's 3-D point: the cloud's point at `pixel` or, where that was not measured, the next
/// measured one on its right in the same row (docs/method.md section 3). Absent when the cloud is
/// not organised, the pixel lies outside it, or nothing on the right was measured.
std::optional<Eigen::Vector3f> toolPointAt(const Cloud& cloud, cv::Point pixel);

/// The same for a tool that fills `box` (pixels): Right looks from the box's centre to its right
/// edge and no further, for what lies beyond it is not the tool. Near takes, of the points measured
/// in the middle half of the box, the one at the lower quartile of depth: a grapple's centre looks
/// between its tines, at the ground. Absent as above.
std::optional<Eigen::Vector3f> toolPointIn(const Cloud& cloud, const cv::Rect2d& box,
                                           ToolPointRule rule);

/// The pixel in the middle of `box`; where that is outside the image, so is the pixel.
cv::Point centreOf(const cv::Rect2d& box);

}  // namespace boomwatch
