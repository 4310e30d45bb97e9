#include "tracking/tool_motion.h"

#include "tracking/tool_motion_tuning.h"

namespace boomwatch {
namespace {
constexpr ToolMotionTuning tuning;

}  // namespace

void ToolMotion::update(double stamp, const std::optional<Eigen::Vector3f>& measured,
                        const TrackingParameters& parameters,
                        const std::optional<Eigen::Vector3f>& held) {
  if (m_stamp && stamp < *m_stamp) reset();
  if (m_known) predict(stamp - *m_stamp, parameters.acceleration);
  m_stamp = stamp;
  if (m_known && *age() > parameters.maxToolAge) m_known = false;
  m_isContradicted = false;
  m_isBelieved = measured && isAccepted(measured->cast<double>(), parameters, held);
  if (!m_isBelieved) return;
  m_believed = m_point;
  m_seenAt = stamp;
  m_outlier.reset();
  m_outliers = 0;
}

bool ToolMotion::isAccepted(const Eigen::Vector3d& measured, const TrackingParameters& parameters,
                            const std::optional<Eigen::Vector3f>& held) {
  const double noise = parameters.noise;
  const bool isApart = held && (measured - held->cast<double>()).norm() > tuning.besideHeld;
  // What is seen to move on, frame by frame, may have let go of the load; what has leapt has not.
  const bool wasSeen = m_isBelieved;  // in the frame before
  const bool leaps = isApart && !wasSeen;
  if (m_known && !leaps && isInReach(measured, parameters) && believe(measured, noise)) return true;
  noteOutlier(measured, noise);
  const bool inReach = isInReach(measured, parameters);
  const bool insists = m_outliers >= tuning.agreeingOutliers;
  if (!insists && (m_known || !inReach)) return false;
  if (isApart || (!inReach && *m_stamp - m_outliersSince < tuning.maxContradiction)) {
    m_isContradicted = insists && !m_known;
    return false;
  }
  begin(measured, noise);
  return true;
}

void ToolMotion::begin(const Eigen::Vector3d& at, double noise) {
  m_known = true;
  m_point = at;
  m_velocity.setZero();
  m_pp = noise * noise;
  m_pv = 0.0;
  m_vv = tuning.firstSpeed * tuning.firstSpeed;
  m_agreed = 1;
}

/// White acceleration in continuous time, so that what comes out does not depend on the frame rate.
void ToolMotion::predict(double seconds, double acceleration) {
  const double q = acceleration * acceleration, t = seconds;
  m_point += t * m_velocity;
  m_pp += t * (2.0 * m_pv + t * m_vv) + q * t * t * t / 3.0;
  m_pv += t * m_vv + q * t * t / 2.0;
  m_vv += q * t;
}

bool ToolMotion::believe(const Eigen::Vector3d& measured, double noise) {
  const Eigen::Vector3d residual = measured - m_point;
  const double variance = m_pp + noise * noise;
  if (residual.squaredNorm() > tuning.gate * variance) return false;
  const double gainP = m_pp / variance, gainV = m_pv / variance;
  m_point += gainP * residual;
  m_velocity += gainV * residual;
  m_vv -= gainV * m_pv;
  m_pv -= gainP * m_pv;
  m_pp -= gainP * m_pp;
  ++m_agreed;
  return true;
}

bool ToolMotion::agreesWithOutlier(const Eigen::Vector3d& measured, double noise) const {
  const double variance = m_pp + noise * noise;
  return m_outlier && (measured - *m_outlier).squaredNorm() <= tuning.gate * variance;
}

void ToolMotion::noteOutlier(const Eigen::Vector3d& measured, double noise) {
  const bool again = agreesWithOutlier(measured, noise);
  if (!again) m_outliersSince = *m_stamp;
  m_outliers = again ? m_outliers + 1 : 1;
  m_outlier = measured;
}

/// Whether the tool can be at `place`, seeing where it was last. While a place out of reach is
/// measured again and again it does not come into reach: the tool would have to be there already.
bool ToolMotion::isInReach(const Eigen::Vector3d& place,
                           const TrackingParameters& parameters) const {
  const double at = agreesWithOutlier(place, parameters.noise) ? m_outliersSince : *m_stamp;
  // Without time between them nothing can be said of the speed.
  if (!m_seenAt || at <= *m_seenAt || m_agreed < tuning.agreedForCertainty) return true;
  return (place - m_believed).norm() <= tuning.toolExtent + parameters.maxSpeed * (at - *m_seenAt);
}

std::optional<Eigen::Vector3f> ToolMotion::point() const {
  return m_known ? std::optional<Eigen::Vector3f>(m_point.cast<float>()) : std::nullopt;
}

std::optional<Eigen::Vector3f> ToolMotion::velocity() const {
  if (!m_known || m_agreed < tuning.agreedForVelocity) return std::nullopt;
  return m_velocity.cast<float>();
}

std::optional<double> ToolMotion::age() const {
  return m_seenAt ? std::optional(*m_stamp - *m_seenAt) : std::nullopt;
}

}  // namespace boomwatch
