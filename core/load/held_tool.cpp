#include "load/held_tool.h"

#include "load/load_tuning.h"

namespace boomwatch {

using Eigen::Vector3d;

void HeldTool::learn(const Eigen::Vector3f& tool, const OrientedBox& load, double stamp) {
  constexpr double gain = LoadTuning::Held().gain;
  if (m_grip && stamp < m_grip->stamp) reset();
  const Vector3d axis = load.rotation.col(0), offset = tool.cast<double>() - load.centre;
  const double along = axis.dot(offset);
  const Vector3d beside = offset - along * axis;
  if (!m_grip || stamp - m_grip->stamp > maxHold) {
    m_grip = Grip{along, beside, stamp};
    return;
  }
  m_grip->along += gain * (along - m_grip->along);
  m_grip->beside += gain * (beside - m_grip->beside);
  m_grip->stamp = stamp;
}

std::optional<Eigen::Vector3f> HeldTool::point(const OrientedBox& load, double stamp) const {
  if (!m_grip || stamp < m_grip->stamp || stamp - m_grip->stamp > maxHold) return std::nullopt;
  const Vector3d tool = load.centre + m_grip->along * load.rotation.col(0) + m_grip->beside;
  return tool.cast<float>();
}

}  // namespace boomwatch
