#include "load/load_follower.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "load/load_tuning.h"

namespace boomwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr LoadTuning::Follower tuning;

/// Farther than a swinging load and the noise of its pose can take it from where it was expected.
bool isTooFar(double metres, double passed) {
  return metres > tuning.jump + tuning.jumpSpeed * passed;
}

/// Axis times radians: turned() by it, `from` becomes `to`.
Vector3d turnBetween(const Matrix3d& from, const Matrix3d& to) {
  const Eigen::AngleAxisd turn(Matrix3d(to * from.transpose()));
  return turn.angle() * turn.axis();
}

Matrix3d turned(const Matrix3d& rotation, const Vector3d& turn) {
  const double angle = turn.norm();
  if (!(angle > 0.0)) return rotation;
  return Quaterniond(Eigen::AngleAxisd(angle, turn / angle) * Quaterniond(rotation))
      .normalized()
      .toRotationMatrix();
}

}  // namespace

OrientedBox namedAs(const OrientedBox& before, const OrientedBox& seen) {
  constexpr std::array<std::array<int, 3>, 6> orders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  OrientedBox best = seen;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& order : orders) {
    OrientedBox named = seen;
    double turn = 0.0, growth = 0.0;
    for (int i = 0; i < 3; ++i) {
      Vector3d axis = seen.rotation.col(order[static_cast<std::size_t>(i)]);
      const double along = axis.dot(before.rotation.col(i));
      if (along < 0.0) axis = -axis;
      named.rotation.col(i) = axis;
      named.size[i] = seen.size[order[static_cast<std::size_t>(i)]];
      turn += 1.0 - std::abs(along);
      growth += std::abs(std::log(named.size[i] / before.size[i]));
    }
    if (named.rotation.determinant() < 0.0) named.rotation.col(2) *= -1.0;
    if (turn + growth < least) least = turn + growth, best = named;
  }
  return best;
}

LoadFollower::Followed LoadFollower::follow(const LoadDetection& detection, double stamp,
                                            const LoadParameters& parameters, double maxAge,
                                            const std::optional<Eigen::Vector3f>& tool) {
  if (m_pose && (stamp < m_pose->stamp || stamp - m_pose->stamp > maxAge)) reset();
  bool isSeen = detection.box.has_value();
  if (isSeen) {
    const OrientedBox seen = m_pose ? namedAs(m_pose->box, *detection.box) : *detection.box;
    const double passed = m_pose ? stamp - m_pose->stamp : 0.0;
    const OrientedBox expected = m_pose ? boxAt(passed, tool) : seen;
    const bool elsewhere = m_pose && jumps(seen, expected, passed);
    m_jumps = elsewhere ? m_jumps + 1 : 0;
    if (!m_pose || m_jumps >= tuning.jumpsToBelieve) {
      begin(seen, stamp);
    } else if (elsewhere) {
      isSeen = false;
    } else {
      correct(seen, expected, passed);
      m_pose->stamp = stamp;
    }
    if (isSeen) m_pose->tool = tool;
    if (isSeen && (detection.isWhole || m_learnt[0].empty())) learn(seen.size, stamp, parameters);
  }
  if (!m_pose) return {};
  const double age = stamp - m_pose->stamp;
  return {boxAt(age, tool), age};
}

void LoadFollower::reset() { *this = LoadFollower(); }

std::optional<OrientedBox> LoadFollower::expected(
    double stamp, double maxAge, const std::optional<Eigen::Vector3f>& tool) const {
  if (!m_pose || stamp < m_pose->stamp || stamp - m_pose->stamp > maxAge) return std::nullopt;
  return boxAt(stamp - m_pose->stamp, tool);
}

bool LoadFollower::jumps(const OrientedBox& seen, const OrientedBox& expected,
                         double passed) const {
  return isTooFar((seen.centre - expected.centre).norm(), passed) ||
         turnBetween(expected.rotation, seen.rotation).norm() >
             tuning.turn + tuning.turnSpeed * passed;
}

void LoadFollower::begin(const OrientedBox& seen, double stamp) {
  if (!m_pose) m_learningSince = stamp;
  m_pose = Pose{seen, Vector3d::Zero(), Vector3d::Zero(), stamp, std::nullopt};
  m_jumps = 0;
}

void LoadFollower::correct(const OrientedBox& seen, const OrientedBox& expected, double passed) {
  Pose& pose = *m_pose;
  const Vector3d off = seen.centre - expected.centre;
  const Vector3d turn = turnBetween(expected.rotation, seen.rotation);
  pose.box.centre = expected.centre + tuning.positionGain * off;
  pose.box.rotation = turned(expected.rotation, tuning.positionGain * turn);
  if (passed <= 0.0) return;
  pose.velocity += tuning.velocityGain / passed * off;
  pose.spin += tuning.spinGain / passed * turn;
}

void LoadFollower::learn(const Vector3d& size, double stamp, const LoadParameters& parameters) {
  if (parameters.dimensions == LoadDimensions::Locked) {
    m_size = size;
    m_learnt = {};
    m_learningSince = stamp;
    return;
  }
  const bool isLearning = m_learnt[0].empty() || stamp - m_learningSince <= parameters.learnTime;
  const Vector3d sight = m_pose->box.centre.normalized();
  for (int i = 0; i < 3; ++i) {
    LearntLength& learnt = m_learnt[static_cast<std::size_t>(i)];
    learnt.learn(size[i], m_pose->box.rotation.col(i).cross(sight).norm(), isLearning);
    m_size[i] = learnt.value();
  }
  // A log is as deep as it is wide, of which the width is seen.
  if (size.y() == size.z()) m_size.z() = m_size.y();
}

OrientedBox LoadFollower::boxAt(double passed, const std::optional<Eigen::Vector3f>& tool) const {
  OrientedBox box = m_pose->box;
  Vector3d way = m_pose->velocity * passed;
  if (passed > tuning.soon && tool && m_pose->tool) {
    const Vector3d ofTool = (*tool - *m_pose->tool).cast<double>();
    // What leaps is something else that the tracker takes for the tool.
    if (!isTooFar((ofTool - way).norm(), passed)) way = ofTool;
  }
  box.centre += way;
  box.rotation = turned(box.rotation, m_pose->spin * std::min(passed, tuning.turning));
  box.size = m_size;
  return box;
}

}  // namespace boomwatch
