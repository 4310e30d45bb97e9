#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

namespace boomwatch {

/// How often a fern (see FernEnsemble) saw one of its codes on the tool and elsewhere.
struct FernLeaf {
  std::uint16_t positive = 0;
  std::uint16_t negative = 0;
  friend bool operator==(const FernLeaf&, const FernLeaf&) = default;
};

/// What a tracker that learns knows of the tool: the model of TLD (Kalal et al., "Tracking-
/// Learning-Detection", 2012). A value: copies are independent, since a patch is never written to
/// once it is here. Bounded in size.
struct ToolModel {
  static constexpr std::size_t maxPositives = 200;
  static constexpr std::size_t maxNegatives = 400;
  static constexpr std::size_t ferns = 10;
  static constexpr std::size_t leavesPerFern = 4096;

  cv::Size2d size;                 ///< of the tool in the image it was begun in, pixels
  std::vector<cv::Mat> positives;  ///< patches of the tool, CV_8UC1 of patchSize(), oldest first
  std::vector<cv::Mat> negatives;  ///< patches of what is not the tool, as positives
  /// One fern after the other.
  std::vector<FernLeaf> leaves = std::vector<FernLeaf>(ferns * leavesPerFern);

  /// The size of every patch: the tool's shape with about 15 x 15 pixels, as in Kalal's paper.
  cv::Size patchSize() const;
};

/// Patches, leaves and size equal, bit for bit.
bool operator==(const ToolModel& one, const ToolModel& other);

/// One model of a tool from several. Throws Error when `models` is empty or they are not of one
/// shape of tool. Where they hold more than one model may, each gives an equal share.
ToolModel mergeToolModels(std::span<const ToolModel> models);

}  // namespace boomwatch
