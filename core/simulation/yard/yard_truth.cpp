#include "simulation/yard/yard_truth.h"

namespace boomwatch {

cv::Mat YardTruth::disparity() const {
  cv::Mat disparity;
  cv::divide(depthTimesDisparity, depth, disparity);
  return disparity;
}

cv::Mat YardTruth::moving() const { return kind >= static_cast<double>(YardKind::Person); }

}  // namespace boomwatch
