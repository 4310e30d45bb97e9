#include "tracking/tool_motion.h"

#include <cmath>

namespace boomwatch {
namespace {

/// 99.9 % of a chi-squared distribution with three degrees of freedom lie below.
constexpr double gate = 16.27;
/// Standard deviation of what is not yet known of the velocity, m/s: cranes are not faster.
constexpr double firstSpeed = 2.0;
constexpr int agreeingOutliers = 3;
constexpr int agreedForVelocity = 3;
/// What so many measurements agreed on is not given up for three others that it cannot explain.
constexpr int agreedForCertainty = 10;

}  // namespace

void ToolMotion::update(double stamp, const std::optional<Eigen::Vector3f>& measured,
                        const TrackingParameters& parameters) {
  if (m_stamp && stamp < *m_stamp) reset();
  if (m_known) predict(stamp - *m_stamp, parameters.acceleration);
  m_stamp = stamp;
  if (m_known && *age() > parameters.maxToolAge) m_known = false;
  m_contradicted = false;
  if (!measured) return;
  const Eigen::Vector3d at = measured->cast<double>();
  if (!m_known || !believe(at, parameters.noise)) {
    const bool inReach = isInReach(at, parameters);
    if ((m_known || !inReach) && !insists(at, parameters.noise)) return;
    m_contradicted = !inReach;
    if (m_contradicted) return;
    begin(at, parameters.noise);
  }
  m_believed = m_point;
  m_seenAt = stamp;
  m_outlier.reset();
  m_outliers = 0;
}

void ToolMotion::begin(const Eigen::Vector3d& at, double noise) {
  m_known = true;
  m_point = at;
  m_velocity.setZero();
  m_pp = noise * noise;
  m_pv = 0.0;
  m_vv = firstSpeed * firstSpeed;
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
  if (residual.squaredNorm() > gate * variance) return false;
  const double gainP = m_pp / variance, gainV = m_pv / variance;
  m_point += gainP * residual;
  m_velocity += gainV * residual;
  m_vv -= gainV * m_pv;
  m_pv -= gainP * m_pv;
  m_pp -= gainP * m_pp;
  ++m_agreed;
  return true;
}

/// Whether `measured`, an outlier, is the third in a row that says the same.
bool ToolMotion::insists(const Eigen::Vector3d& measured, double noise) {
  const double variance = m_pp + noise * noise;
  const bool again = m_outlier && (measured - *m_outlier).squaredNorm() <= gate * variance;
  m_outliers = again ? m_outliers + 1 : 1;
  m_outlier = measured;
  return m_outliers >= agreeingOutliers;
}

bool ToolMotion::isInReach(const Eigen::Vector3d& place,
                           const TrackingParameters& parameters) const {
  if (!m_seenAt || m_agreed < agreedForCertainty) return true;
  const double reach =
      parameters.fastest * (*m_stamp - *m_seenAt) + std::sqrt(gate) * parameters.noise;
  return (place - m_believed).norm() <= reach;
}

std::optional<Eigen::Vector3f> ToolMotion::point() const {
  return m_known ? std::optional<Eigen::Vector3f>(m_point.cast<float>()) : std::nullopt;
}

std::optional<Eigen::Vector3f> ToolMotion::velocity() const {
  if (!m_known || m_agreed < agreedForVelocity) return std::nullopt;
  return m_velocity.cast<float>();
}

std::optional<double> ToolMotion::age() const {
  return m_seenAt ? std::optional(*m_stamp - *m_seenAt) : std::nullopt;
}

}  // namespace boomwatch
