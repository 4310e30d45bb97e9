#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>

#include "frame/cloud.h"

namespace boomwatch {

/// Surface points of a depth image (CV_32FC1, metres, NaN where there is none). Organised,
/// with the camera.
std::shared_ptr<const Cloud> cloudOf(const cv::Mat& depth, const PinholeCamera& camera);

/// Depth as a file of 16 bits holds it.
void roundToMillimetres(cv::Mat& depth);

/// Of which noise frame `index` of the yard with this seed has; see addDepthNoise.
inline std::uint64_t depthNoiseStream(std::uint64_t seed, std::size_t index) {
  return (seed << 20) + index;
}

}  // namespace boomwatch
