#include "tracking/tool_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace boomwatch {
namespace {

constexpr double patchArea = 15.0 * 15.0;
constexpr double maxPatchSide = 45.0;
constexpr double minPatchSide = 5.0;

bool samePatches(const std::vector<cv::Mat>& one, const std::vector<cv::Mat>& other) {
  return std::ranges::equal(one, other, [](const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
  });
}

/// Takes `share` of `from`, evenly over its age, behind `to`.
void appendShare(std::vector<cv::Mat>& to, const std::vector<cv::Mat>& from, std::size_t share) {
  const std::size_t taken = std::min(share, from.size());
  for (std::size_t i = 0; i < taken; ++i) to.push_back(from[i * from.size() / taken]);
}

void addLeaf(FernLeaf& to, const FernLeaf& leaf) {
  unsigned positive = to.positive + leaf.positive;
  unsigned negative = to.negative + leaf.negative;
  // What counts is their ratio.
  while (std::max(positive, negative) > std::numeric_limits<std::uint16_t>::max()) {
    positive /= 2;
    negative /= 2;
  }
  to = {static_cast<std::uint16_t>(positive), static_cast<std::uint16_t>(negative)};
}

}  // namespace

cv::Size ToolModel::patchSize() const {
  if (size.empty()) return {};
  const double area = std::min(patchArea, size.area());
  const double width = std::sqrt(area * size.width / size.height);
  const auto side = [](double length) {
    return cvRound(std::clamp(length, minPatchSide, maxPatchSide));
  };
  return {side(width), side(area / width)};
}

bool operator==(const ToolModel& one, const ToolModel& other) {
  return one.size == other.size && one.leaves == other.leaves &&
         samePatches(one.positives, other.positives) && samePatches(one.negatives, other.negatives);
}

ToolModel mergeToolModels(std::span<const ToolModel> models) {
  if (models.empty()) {
    throw Error("tool models", "there is none to merge", "Choose at least one file.");
  }
  ToolModel merged;
  merged.size = models.front().size;
  for (const ToolModel& model : models) {
    if (model.patchSize() != merged.patchSize()) {
      throw Error("tool models", "they are not of one shape of tool",
                  "Merge models whose boxes were drawn around the same tool.");
    }
    appendShare(merged.positives, model.positives, ToolModel::maxPositives / models.size());
    appendShare(merged.negatives, model.negatives, ToolModel::maxNegatives / models.size());
    for (std::size_t i = 0; i < merged.leaves.size(); ++i) {
      addLeaf(merged.leaves[i], model.leaves[i]);
    }
  }
  return merged;
}

}  // namespace boomwatch
