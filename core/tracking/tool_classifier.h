#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "tracking/fern_ensemble.h"
#include "tracking/learnt_patches.h"
#include "tracking/tool_model.h"

namespace boomwatch {

/// How much a patch looks like the tool (Kalal et al., "Tracking-Learning-Detection", 2012,
/// section 5.2). Both 0..1.
struct Likeness {
  float relative = 0.0F;      ///< to the tool, against what is not the tool
  float conservative = 0.0F;  ///< the same with the older half of the tool's patches only
};

/// A ToolModel ready for use: answers what a patch is, and learns.
class ToolClassifier {
 public:
  explicit ToolClassifier(const ToolModel& model);

  cv::Size patchSize() const { return m_patch; }
  cv::Size2d toolSize() const { return m_size; }
  const FernEnsemble& ferns() const { return m_ferns; }
  /// Patches with less variance than this are not the tool.
  double minVariance() const { return m_minVariance; }
  Likeness likeness(const cv::Mat& patch) const;
  /// To the older half of the tool's patches alone, whatever else there is: 0..1.
  float anchorLikeness(const cv::Mat& patch) const;

  FernEnsemble& ferns() { return m_ferns; }
  void learnPositive(const cv::Mat& patch);
  void learnNegative(const cv::Mat& patch) { m_negatives.add(patch); }

  ToolModel model() const;

 private:
  void lowerVariance(const cv::Mat& patch);

  cv::Size2d m_size;
  cv::Size m_patch;
  FernEnsemble m_ferns;
  LearntPatches m_positives;
  LearntPatches m_negatives;
  double m_minVariance = 0.0;
};

}  // namespace boomwatch
