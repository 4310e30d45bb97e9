#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "frame/cloud.h"

namespace boomwatch {

/// The tool's 3-D point: the cloud's point at `pixel` or, where that was not measured, the next
/// measured one on its right in the same row (method.md section 3). Absent when the cloud is not
/// organised, the pixel lies outside it, or nothing on the right was measured.
std::optional<Eigen::Vector3f> toolPointAt(const Cloud& cloud, cv::Point pixel);

}  // namespace boomwatch
