#include "crane/boom_beyond.h"

#include <Eigen/Eigenvalues>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

// Metres: half the width of a boom, including the noise of stereo matching.
constexpr double jibRadius = 0.15, boomRadius = 0.25;

/// The point of each axis that is nearest to the other axis.
struct Crossing {
  Vector3d onA, onB;
};
std::optional<Crossing> crossing(const Beam& a, const Beam& b) {
  constexpr double minSine2 = 0.03;  // 10 degrees; nearly parallel axes have no certain crossing
  const Vector3d apart = b.centre - a.centre;
  const double cosine = a.axis.dot(b.axis), sine2 = 1.0 - cosine * cosine;
  if (sine2 < minSine2) return std::nullopt;
  const double onA = apart.dot(a.axis), onB = apart.dot(b.axis);
  return Crossing{a.centre + (onA - cosine * onB) / sine2 * a.axis,
                  b.centre + (cosine * onA - onB) / sine2 * b.axis};
}

}  // namespace

BoomBeyond::BoomBeyond(const Points& seen, const std::optional<PinholeCamera>& camera)
    : m_camera(camera), m_jib(beamIn(seen, jibRadius)) {
  constexpr double minLength = 0.6;  // metres; the axis of a shorter jib is uncertain
  if (m_jib && m_jib->length < minLength) m_jib.reset();
}

bool BoomBeyond::isPart(const Points& cluster) const {
  // Metres by which the axes may miss each other, and how much each length of extrapolation adds.
  constexpr double miss = 0.3, missMore = 0.12;
  constexpr double maxToElbow = 4.0;  // metres from an end to the elbow
  constexpr double minShare = 0.8;    // of the cluster's points in the beam
  if (!m_camera || !m_jib) return false;
  const auto beam = beamIn(cluster, boomRadius);
  if (!beam || beam->share < minShare) return false;
  const auto elbow = crossing(*m_jib, *beam);
  if (!elbow) return false;
  const double beyondJib = m_jib->beyondEnd(elbow->onA), beyondBeam = beam->beyondEnd(elbow->onB);
  const double lengths = beyondJib / m_jib->length + beyondBeam / beam->length;
  return (elbow->onA - elbow->onB).norm() <= miss + missMore * lengths && beyondJib < maxToElbow &&
         beyondBeam < maxToElbow && leavesPicture(*m_jib, elbow->onA) &&
         leavesPicture(*beam, elbow->onB);
}

/// Whether the beam ends at the edge of the picture, on the side of `towards`, a point of its axis.
bool BoomBeyond::leavesPicture(const Beam& beam, const Vector3d& towards) const {
  constexpr double room = 0.3;  // metres: the edge of the picture cuts a beam at a slant
  if (beam.beyondEnd(towards) < room) return false;
  const Vector3d next =
      beam.centre + (beam.length / 2 + room) * (towards - beam.centre).normalized();
  if (!(next.z() > 0.0)) return true;
  return !m_camera->contains(m_camera->project(next));
}

void Spread::add(const Eigen::Vector3f& p) {
  const Vector3d point = p.cast<double>();
  m_count += 1.0;
  m_sum += point;
  m_squares += point * point.transpose();
}

bool Spread::mayBeStraight() const {
  constexpr double slender = 1.5;
  if (m_count < 2.0) return false;
  const Vector3d mean = m_sum / m_count;
  const Eigen::Matrix3d spread = m_squares / m_count - mean * mean.transpose();
  const Vector3d ascending =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  // The variance across a strip of width w is w^2 / 12.
  return ascending[2] >= slender * ascending[1] &&
         12.0 * ascending[1] <= 4.0 * boomRadius * boomRadius;
}

}  // namespace boomwatch
