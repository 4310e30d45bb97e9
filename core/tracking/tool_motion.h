#pragma once

#include <Eigen/Core>
#include <optional>

#include "pipeline/parameters.h"

namespace boomwatch {

/// The tool's point over time: a Kalman filter for constant velocity, alike on all three axes.
/// A measurement too far from where the tool is expected is not believed; three such in a row that
/// agree with one another are, and the filter begins anew there, unless the tool cannot have got
/// there since it was last seen: they contradict it. Camera frame, metres, seconds.
class ToolMotion {
 public:
  /// One frame on: to `stamp`, seconds on the source's clock, with the point measured there.
  /// Beyond maxToolAge without one that is believed, and when the clock went backwards, everything
  /// but the age is forgotten.
  void update(double stamp, const std::optional<Eigen::Vector3f>& measured,
              const TrackingParameters& parameters);
  void reset() { *this = ToolMotion(); }

  /// Whether the last measurements insist on a place that the tool cannot have reached: whoever
  /// measured them follows something else.
  bool contradicted() const { return m_contradicted; }

  /// Where the tool is at the last stamp: smoothed, or carried on with its velocity as long as the
  /// age is within maxToolAge. Absent: not known.
  std::optional<Eigen::Vector3f> point() const;
  /// Metres a second; absent until three measurements agreed.
  std::optional<Eigen::Vector3f> velocity() const;
  /// Seconds since a measurement was last believed, 0 in its own frame; absent: never.
  std::optional<double> age() const;

 private:
  void begin(const Eigen::Vector3d& at, double noise);
  void predict(double seconds, double acceleration);
  bool believe(const Eigen::Vector3d& measured, double noise);
  bool insists(const Eigen::Vector3d& measured, double noise);
  bool isInReach(const Eigen::Vector3d& place, const TrackingParameters& parameters) const;

  bool m_known = false;  ///< point and velocity hold
  Eigen::Vector3d m_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_velocity = Eigen::Vector3d::Zero();
  double m_pp = 0.0, m_pv = 0.0, m_vv = 0.0;             ///< covariance, of each axis
  int m_agreed = 0;                                      ///< measurements since it began
  Eigen::Vector3d m_believed = Eigen::Vector3d::Zero();  ///< the point at m_seenAt
  bool m_contradicted = false;
  std::optional<Eigen::Vector3d> m_outlier;  ///< the last one that was not believed
  int m_outliers = 0;                        ///< in a row, each near the one before
  std::optional<double> m_stamp;
  std::optional<double> m_seenAt;
};

}  // namespace boomwatch
