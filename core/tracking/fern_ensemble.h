#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "tracking/tool_model.h"

namespace boomwatch {

/// The second stage of TLD's detector: ten ferns, each of twelve comparisons of two pixels of a
/// patch. A fern's answer is the share of the tool among the patches that gave the same comparisons
/// (Kalal et al., "Tracking-Learning-Detection", 2012, section 5.3.2). Which pixels are compared
/// follows from the patch's size alone, so that statistics fit every ensemble of that size.
class FernEnsemble {
 public:
  static constexpr std::size_t ferns = ToolModel::ferns;
  static constexpr std::size_t comparisons = 12;
  static_assert(std::size_t{1} << comparisons == ToolModel::leavesPerFern);

  using Codes = std::array<std::uint16_t, ferns>;

  FernEnsemble(cv::Size patch, std::vector<FernLeaf> leaves);

  const std::vector<FernLeaf>& leaves() const { return m_leaves; }
  /// The pixels of a patch that are compared, the ferns one after the other.
  const std::vector<std::array<cv::Point, 2>>& pairs() const { return m_pairs; }

  /// Share of the tool, 0..1, mean over the ferns; 0 as soon as it cannot reach `least`.
  float toolShare(const Codes& codes, float least) const;
  Codes codesOf(const cv::Mat& patch) const;

  void learn(const Codes& codes, bool positive);

 private:
  std::vector<std::array<cv::Point, 2>> m_pairs;
  std::vector<FernLeaf> m_leaves;
  std::vector<float> m_shares;  ///< of the tool, for each leaf
};

}  // namespace boomwatch
