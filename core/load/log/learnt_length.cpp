#include "load/log/learnt_length.h"

#include <algorithm>

#include "base/median.h"
#include "load/log/log_tuning.h"

namespace boomwatch {
namespace {

constexpr LogTuning::Length tuning;

}  // namespace

void LearntLength::learn(double length, double crosswise, bool isLearningTime) {
  const Sample seen{length, std::max(crosswise, tuning.minCrosswise)};
  if (isLearningTime) {
    m_samples.push_back(seen);
  } else {
    const auto least = std::ranges::min_element(m_samples, {}, &Sample::crosswise);
    if (least == m_samples.end() || seen.crosswise < tuning.clearly * least->crosswise) return;
    *least = seen;
  }
  std::vector<double> lengths;
  for (const Sample& sample : m_samples) lengths.push_back(sample.length);
  m_value = medianOf(lengths);
}

}  // namespace boomwatch
