#include "pipeline/load_warning.h"

#include <algorithm>

namespace boomwatch {
namespace {

Approach approachOf(const LoadAndClearance& input, const Eigen::Vector3d& velocity,
                    const ExactClearance& environment, const WarningParameters& parameters) {
  Approach approach;
  approach.velocity = velocity;
  const auto& nearest = input.clearance.nearest;
  if (input.isOfLoad && nearest && nearest->distance > 0.0) {
    approach.closingSpeed =
        velocity.dot(nearest->onEnvironment - nearest->onLoad) / nearest->distance;
  }
  approach.timeToContact = timeToContact(environment, *input.load, velocity,
                                         std::max(parameters.cautionTime, parameters.warningTime));
  return approach;
}

}  // namespace

LoadWarning::Outcome LoadWarning::update(const LoadAndClearance& input,
                                         const ExactClearance& environment,
                                         const WarningParameters& parameters) {
  Outcome outcome;
  if (input.load) {
    const auto velocity = m_motion.update(input.stamp, input.load->centre);
    if (velocity && input.clearance.state != ClearanceState::Unknown) {
      outcome.approach = approachOf(input, *velocity, environment, parameters);
    }
  } else {
    m_motion.reset();
  }
  m_memory = nextWarning(m_memory, {input.stamp, input.clearance, outcome.approach}, parameters);
  outcome.level = m_memory.level;
  return outcome;
}

}  // namespace boomwatch
