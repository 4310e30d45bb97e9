#include "tracking/tool_classifier.h"

#include <limits>

#include "tracking/patch_cutter.h"
#include "tracking/tld_tuning.h"

namespace boomwatch {
namespace {

constexpr TldTuning tuning;

}  // namespace

ToolClassifier::ToolClassifier(const ToolModel& model)
    : m_size(model.size),
      m_patch(model.patchSize()),
      m_ferns(m_patch, model.leaves),
      m_positives(model.positives, m_patch, ToolModel::maxPositives),
      m_negatives(model.negatives, m_patch, ToolModel::maxNegatives),
      m_minVariance(std::numeric_limits<double>::infinity()) {
  for (const cv::Mat& patch : model.positives) lowerVariance(patch);
}

void ToolClassifier::lowerVariance(const cv::Mat& patch) {
  m_minVariance = std::min(m_minVariance, tuning.varianceShare * varianceOf(patch));
}

Likeness ToolClassifier::likeness(const cv::Mat& patch) const {
  const Eigen::VectorXf pixels = normalised(patch);
  const float other = 1.0F - m_negatives.likeness(pixels);
  const auto against = [&](float tool) {
    const float distance = 1.0F - tool;
    return distance + other > 0.0F ? other / (distance + other) : 0.0F;
  };
  return {against(m_positives.likeness(pixels)),
          against(m_positives.likeness(pixels, tuning.olderHalf))};
}

float ToolClassifier::anchorLikeness(const cv::Mat& patch) const {
  return m_positives.likeness(normalised(patch), tuning.olderHalf);
}

void ToolClassifier::learnPositive(const cv::Mat& patch) {
  m_positives.add(patch);
  lowerVariance(patch);
}

ToolModel ToolClassifier::model() const {
  ToolModel model;
  model.size = m_size;
  model.positives = m_positives.patches();
  model.negatives = m_negatives.patches();
  model.leaves = m_ferns.leaves();
  return model;
}

}  // namespace boomwatch
