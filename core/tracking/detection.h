#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "tracking/scan_levels.h"
#include "tracking/tool_classifier.h"

namespace boomwatch {

/// A window that the ferns took for the tool, and what the patches say to it.
struct Candidate {
  cv::Rect2d box;  ///< pixels of the picture
  ScanWindow window;
  float share = 0.0F;  ///< the ferns' answer, 0..1
  Likeness likeness;
};

/// Boxes that mean the same thing, as one.
struct Detection {
  cv::Rect2d box;
  Likeness likeness;  ///< of the best of them
};

/// Intersection over union.
double overlap(const cv::Rect2d& one, const cv::Rect2d& other);

/// The cascade of TLD's detector over all windows: variance, ferns, patches. Returns what passed
/// the ferns, most likely first, at most 100.
std::vector<Candidate> findCandidates(const ScanLevels& levels, const ToolClassifier& tool);

/// The candidates that are the tool, those that overlap by half as one: most alike first, at most
/// five.
std::vector<Detection> clusterDetections(const std::vector<Candidate>& candidates);

}  // namespace boomwatch
