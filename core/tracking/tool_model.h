#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

namespace boomwatch {

/// What a tracker that learns knows of the tool: the model of TLD (Kalal et al., "Tracking-
/// Learning-Detection", 2012). A value: copies are independent. Bounded in size.
struct ToolModel {
  cv::Size2d size;                 ///< of the tool in the image it was begun in, pixels
  std::vector<cv::Mat> positives;  ///< patches of the tool, CV_8UC1, oldest first
  std::vector<cv::Mat> negatives;  ///< patches of what is not the tool, as positives
};

/// Writes a versioned file that loadToolModel() reads. Throws Error naming the file when it cannot
/// be written; an older file of that name is then left as it was.
void saveToolModel(const ToolModel& model, const std::string& file);

/// Throws Error that names the file when it is missing, truncated, damaged, of another kind or of
/// another version. Memory stays bounded whatever the file claims.
ToolModel loadToolModel(const std::string& file);

/// One model of a tool from several. Throws Error when `models` is empty or they are not of one
/// shape of tool.
ToolModel mergeToolModels(std::span<const ToolModel> models);

}  // namespace boomwatch
