#pragma once

#include <Eigen/Core>
#include <optional>

#include "parameters/parameters.h"

namespace boomwatch {

/// The tool's point over time: a Kalman filter for constant velocity, alike on all three axes.
/// A measurement too far from where the tool is expected is not believed; three such in a row that
/// agree with one another are, and the filter begins anew there. Not so where ten had agreed before
/// and the tool cannot have got there since (TrackingParameters::maxSpeed): that is believed only
/// after it was insisted on for three seconds. Camera frame, metres, seconds.
class ToolMotion {
 public:
  /// One frame on: to `stamp`, seconds on the source's clock, with the point measured there.
  /// Beyond maxToolAge without one that is believed, point and velocity are not known; when the
  /// clock went backwards, everything is forgotten. `held`: where the tool is by a load that is
  /// seen in it; a measurement that leaps away from that is contradicted.
  void update(double stamp, const std::optional<Eigen::Vector3f>& measured,
              const TrackingParameters& parameters,
              const std::optional<Eigen::Vector3f>& held = {});
  void reset() { *this = ToolMotion(); }

  /// Whether the last measurement was believed.
  bool believed() const { return m_isBelieved; }
  /// Whether it is maxToolAge since one was, and the last ones insist on a place that the tool
  /// cannot have reached, or on one apart from the load that it holds: most likely, whoever
  /// measured them follows something else.
  bool contradicted() const { return m_isContradicted; }

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
  bool agreesWithOutlier(const Eigen::Vector3d& measured, double noise) const;
  void noteOutlier(const Eigen::Vector3d& measured, double noise);
  bool isInReach(const Eigen::Vector3d& place, const TrackingParameters& parameters) const;
  bool isAccepted(const Eigen::Vector3d& measured, const TrackingParameters& parameters,
                  const std::optional<Eigen::Vector3f>& held);

  bool m_known = false;  ///< point and velocity hold
  Eigen::Vector3d m_point = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_velocity = Eigen::Vector3d::Zero();
  double m_pp = 0.0, m_pv = 0.0, m_vv = 0.0;             ///< covariance, of each axis
  int m_agreed = 0;                                      ///< measurements since it began
  Eigen::Vector3d m_believed = Eigen::Vector3d::Zero();  ///< the point at m_seenAt
  bool m_isBelieved = false, m_isContradicted = false;
  std::optional<Eigen::Vector3d> m_outlier;  ///< the last one that was not believed
  int m_outliers = 0;                        ///< in a row, each near the one before
  double m_outliersSince = 0.0;              ///< stamp of the first of these
  std::optional<double> m_stamp;
  std::optional<double> m_seenAt;
};

}  // namespace boomwatch
