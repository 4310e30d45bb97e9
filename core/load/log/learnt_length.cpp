#include "load/log/learnt_length.h"

#include <algorithm>

#include "base/median.h"

namespace boomwatch {
namespace {

/// Sine below which one view is no better than another: there the angle itself is not known.
constexpr double minCrosswise = 0.2;

/// By which a view must be better, so that the noise of the angle does not choose.
constexpr double clearly = 1.2;

}  // namespace

void LearntLength::learn(double length, double crosswise, bool isLearningTime) {
  const Sample seen{length, std::max(crosswise, minCrosswise)};
  if (isLearningTime) {
    m_samples.push_back(seen);
  } else {
    const auto least = std::ranges::min_element(m_samples, {}, &Sample::crosswise);
    if (least == m_samples.end() || seen.crosswise < clearly * least->crosswise) return;
    *least = seen;
  }
  std::vector<double> lengths;
  for (const Sample& sample : m_samples) lengths.push_back(sample.length);
  m_value = medianOf(lengths);
}

}  // namespace boomwatch
