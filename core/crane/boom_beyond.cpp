#include "crane/boom_beyond.h"

#include <Eigen/Eigenvalues>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

// Metres: half the width of a boom, as it is held with the noise of matching.
constexpr double jibRadius = 0.15, boomRadius = 0.25;

/// Where two lines come nearest to each other: a point of each.
struct Crossing {
  Vector3d onA, onB;
};
std::optional<Crossing> crossing(const Beam& a, const Beam& b) {
  constexpr double minSine2 = 0.03;  // 10 degrees: of nearly parallel lines it says nothing
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
  constexpr double shortest = 0.6;  // metres: of less the axis is uncertain
  if (m_jib && m_jib->length < shortest) m_jib.reset();
}

bool BoomBeyond::isPart(const Points& piece) const {
  // Metres by which the axes may miss each other, and what a length of extrapolation adds.
  constexpr double miss = 0.3, missMore = 0.12;
  constexpr double farthest = 4.0;  // metres from an end to the elbow
  constexpr double mostly = 0.8;
  if (!m_camera || !m_jib) return false;
  const auto beam = beamIn(piece, boomRadius);
  if (!beam || beam->share < mostly) return false;
  const auto elbow = crossing(*m_jib, *beam);
  if (!elbow) return false;
  const double beyondJib = m_jib->beyondEnd(elbow->onA), beyondBeam = beam->beyondEnd(elbow->onB);
  const double lengths = beyondJib / m_jib->length + beyondBeam / beam->length;
  return (elbow->onA - elbow->onB).norm() <= miss + missMore * lengths && beyondJib < farthest &&
         beyondBeam < farthest && leavesPicture(*m_jib, elbow->onA) &&
         leavesPicture(*beam, elbow->onB);
}

/// At its end, on the way to a point of its axis.
bool BoomBeyond::leavesPicture(const Beam& beam, const Vector3d& towards) const {
  constexpr double room = 0.3;  // metres: the end of a beam that the edge cuts is slanted
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
  // Of a strip as wide as w the variance across is w^2 / 12.
  return ascending[2] >= slender * ascending[1] &&
         12.0 * ascending[1] <= 4.0 * boomRadius * boomRadius;
}

}  // namespace boomwatch
