#include "tracking/learnt_patches.h"

#include <algorithm>
#include <cmath>

#include "tracking/patch_cutter.h"

namespace boomwatch {

LearntPatches::LearntPatches(std::vector<cv::Mat> patches, cv::Size patch, std::size_t most)
    : m_most(most), m_patches(std::move(patches)) {
  m_columns.setZero(patch.area(), static_cast<Eigen::Index>(most));
  for (std::size_t i = 0; i < m_patches.size(); ++i) {
    m_columns.col(static_cast<Eigen::Index>(i)) = normalised(m_patches[i]);
  }
}

float LearntPatches::likeness(const Eigen::VectorXf& normalised, double share) const {
  if (m_patches.empty()) return 0.0F;
  const auto count = static_cast<Eigen::Index>(std::ceil(share * m_patches.size()));
  const float best = (m_columns.leftCols(count).transpose() * normalised).maxCoeff();
  return std::clamp((best + 1.0F) / 2.0F, 0.0F, 1.0F);
}

void LearntPatches::add(const cv::Mat& patch) {
  if (m_patches.size() == m_most) forget();
  m_columns.col(static_cast<Eigen::Index>(m_patches.size())) = normalised(patch);
  m_patches.push_back(patch.clone());
}

void LearntPatches::forget() {
  Eigen::MatrixXf likeness = m_columns.transpose() * m_columns;
  likeness.diagonal().setConstant(-2.0F);
  std::vector<Eigen::Index> gone;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, m_most / 10); ++i) {
    Eigen::Index one = 0, other = 0;
    likeness.maxCoeff(&one, &other);
    const Eigen::Index younger = std::max(one, other);
    likeness.row(younger).setConstant(-2.0F);
    likeness.col(younger).setConstant(-2.0F);
    gone.push_back(younger);
  }
  std::ranges::sort(gone, std::greater());
  for (const Eigen::Index index : gone) remove(static_cast<std::size_t>(index));
}

void LearntPatches::remove(std::size_t index) {
  m_patches.erase(m_patches.begin() + static_cast<std::ptrdiff_t>(index));
  const auto first = static_cast<Eigen::Index>(index);
  const Eigen::Index behind = m_columns.cols() - 1 - first;
  m_columns.middleCols(first, behind) = m_columns.rightCols(behind).eval();
}

}  // namespace boomwatch
