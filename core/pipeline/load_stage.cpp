#include "pipeline/load_stage.h"

#include "collision/nearest_pair.h"
#include "load/load_detector.h"
#include "pipeline/load_source.h"

namespace boomwatch {
namespace {

/// More than the bare box: the load's own surface lies on that, and half of it would stay as an
/// obstacle.
std::optional<ViewedBox> maskedVolume(const CarriedLoad& load, const SensedFrame& sensed,
                                      const Parameters& parameters) {
  if (!load.box || !isUsable(*load.box)) return std::nullopt;
  const double margin =
      load.source == LoadSource::Detected ? parameters.load.margin : parameters.model.resolution;
  return dynamicVolume(*load.box, margin, sensed.whole->noise.deviation, inverseDepthSmear(sensed));
}

}  // namespace

CarriedLoad LoadStage::update(const Frame& frame, const SensedFrame& sensed, const ToolTrack& tool,
                              const Parameters& parameters) {
  CarriedLoad load;
  const LoadSource source = loadSource(parameters.load.source, frame, tool);
  if (source == LoadSource::Detected && isToolNamed(tool)) {
    load = detect(sensed, frame.stamp, tool, parameters);
  } else {
    m_follower.reset();
    m_held.reset();
    if (source == LoadSource::Detected) load.fault = LoadFault::NoToolPoint;
    if (source == LoadSource::Manual) load.box = parameters.load.box();
    if (source == LoadSource::Scene) load.box = frame.load;
  }
  load.source = source;
  load.volume = maskedVolume(load, sensed, parameters);
  return load;
}

CarriedLoad LoadStage::detect(const SensedFrame& sensed, double stamp, const ToolTrack& tool,
                              const Parameters& parameters) {
  const double maxAge = parameters.validity.maxLoadAge;
  const LoadDetection detection =
      tool.point
          ? detectLoad(*sensed.whole, *tool.point, sensed.whole->noise.deviation, parameters.bounds,
                       parameters.load, m_follower.expected(stamp, maxAge, tool.point))
          : LoadDetection::refused(LoadFault::NoToolPoint);
  const LoadFollower::Followed followed =
      m_follower.follow(detection, stamp, parameters.load, maxAge, tool.point);
  if (!followed.box) m_held.reset();
  if (followed.age == 0.0 && tool.age == 0.0) m_held.learn(*tool.point, *followed.box, stamp);

  CarriedLoad load;
  load.box = followed.box;
  load.fault = detection.fault;
  load.age = followed.age;
  return load;
}

std::optional<Eigen::Vector3f> LoadStage::heldToolPoint(double stamp, double maxAge) const {
  const auto load = m_follower.expected(stamp, maxAge);
  return load ? m_held.point(*load, stamp) : std::nullopt;
}

}  // namespace boomwatch
