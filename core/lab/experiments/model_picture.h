#pragma once

#include <opencv2/core.hpp>

#include "environment/environment_model.h"

namespace boomwatch {

/// The environment model as Fig. 14 prints it, CV_8UC1, a pixel a cell: nearer is brighter,
/// observed and free dark grey, never observed in fine stripes.
cv::Mat modelPicture(const EnvironmentModel& model);

/// The probability map as Fig. 13 prints it: more probable is brighter.
cv::Mat probabilityPicture(const EnvironmentModel& model);

/// `times` as large, with sharp edges.
cv::Mat enlarged(const cv::Mat& picture, int times);

/// Pictures of one height side by side.
cv::Mat besideEachOther(const cv::Mat& left, const cv::Mat& right);

}  // namespace boomwatch
