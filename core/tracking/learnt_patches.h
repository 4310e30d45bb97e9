#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

namespace boomwatch {

/// A bounded set of patches that are searched for the one most alike.
class LearntPatches {
 public:
  LearntPatches(std::vector<cv::Mat> patches, cv::Size patch, std::size_t most);

  const std::vector<cv::Mat>& patches() const { return m_patches; }
  bool empty() const { return m_patches.empty(); }

  /// Likeness to the most alike patch among the first `share` of all, 0..1 (half the correlation
  /// plus a half); 0 when there is none. `normalised`: see patch_cutter.h.
  float likeness(const Eigen::VectorXf& normalised, double share = 1.0) const;

  /// Copies `patch` into the set. In a full set, the younger of the two patches that are most alike
  /// goes, until a tenth is free: what no other patch replaces is kept.
  void add(const cv::Mat& patch);

 private:
  void forget();
  void remove(std::size_t index);

  std::size_t m_most;
  std::vector<cv::Mat> m_patches;
  Eigen::MatrixXf m_columns;  ///< one normalised patch a column, m_patches.size() of them in use
};

}  // namespace boomwatch
