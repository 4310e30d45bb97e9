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
  /// The pixels compared, as steps from a window's first pixel in an image of known row length.
  using Offsets = std::vector<std::array<int, 2>>;

  FernEnsemble(cv::Size patch, std::vector<FernLeaf> leaves);

  const std::vector<FernLeaf>& leaves() const { return m_leaves; }
  Offsets offsetsFor(const cv::Mat& image) const;

  /// Share of the tool, 0..1, mean over the ferns.
  float of(const Codes& codes) const;
  /// As of() for the window whose first pixel is `first`; 0 as soon as it cannot reach `least`.
  float of(const uchar* first, const Offsets& offsets, float least) const;
  Codes codesOf(const cv::Mat& patch) const;

  void learn(const Codes& codes, bool positive);

 private:
  static std::uint16_t codeOf(const uchar* first, const std::array<int, 2>* offsets);

  std::vector<std::array<cv::Point, 2>> m_pairs;
  std::vector<FernLeaf> m_leaves;
  std::vector<float> m_shares;  ///< of the tool, for each leaf
};

}  // namespace boomwatch
