#include "tracking/fern_ensemble.h"

#include <limits>
#include <random>

namespace boomwatch {
namespace {

float shareOf(const FernLeaf& leaf) {
  const int seen = leaf.positive + leaf.negative;
  return leaf.positive == 0 ? 0.0F : static_cast<float>(leaf.positive) / static_cast<float>(seen);
}

}  // namespace

FernEnsemble::FernEnsemble(cv::Size patch, std::vector<FernLeaf> leaves)
    : m_pairs(ferns * comparisons), m_leaves(std::move(leaves)), m_shares(m_leaves.size()) {
  std::mt19937 random(1);  // NOLINT(bugprone-random-generator-seed): the same pairs every time
  const auto below = [&](int limit) {
    return static_cast<int>(random() % static_cast<unsigned>(limit));
  };
  for (auto& [one, other] : m_pairs) {
    do {
      one = {below(patch.width), below(patch.height)};
      other = {below(patch.width), below(patch.height)};
    } while (one == other);
  }
  for (std::size_t i = 0; i < m_leaves.size(); ++i) m_shares[i] = shareOf(m_leaves[i]);
}

FernEnsemble::Codes FernEnsemble::codesOf(const cv::Mat& patch) const {
  Codes codes{};
  for (std::size_t i = 0; i < m_pairs.size(); ++i) {
    const auto& [one, other] = m_pairs[i];
    const unsigned bit = patch.at<uchar>(one) > patch.at<uchar>(other) ? 1U : 0U;
    std::uint16_t& code = codes[i / comparisons];
    code = static_cast<std::uint16_t>(code << 1U | bit);
  }
  return codes;
}

float FernEnsemble::toolShare(const Codes& codes, float least) const {
  float sum = 0.0F;
  for (std::size_t fern = 0; fern < ferns; ++fern) {
    sum += m_shares[fern * ToolModel::leavesPerFern + codes[fern]];
    if (sum + static_cast<float>(ferns - 1 - fern) < least * ferns) return 0.0F;
  }
  return sum / ferns;
}

void FernEnsemble::learn(const Codes& codes, bool positive) {
  for (std::size_t fern = 0; fern < ferns; ++fern) {
    const std::size_t index = fern * ToolModel::leavesPerFern + codes[fern];
    FernLeaf& leaf = m_leaves[index];
    std::uint16_t& count = positive ? leaf.positive : leaf.negative;
    if (count == std::numeric_limits<std::uint16_t>::max()) {
      leaf.positive /= 2;
      leaf.negative /= 2;
    }
    ++count;
    m_shares[index] = shareOf(leaf);
  }
}

}  // namespace boomwatch
