#pragma once

#include <Eigen/Core>
#include <optional>

#include "frame/frame.h"
#include "frame/oriented_box.h"
#include "frame/viewed_box.h"
#include "load/held_tool.h"
#include "load/load_detection.h"
#include "load/load_follower.h"
#include "parameters/parameters.h"
#include "pipeline/sensing_stage.h"
#include "tracking/tool_track.h"

namespace boomwatch {

/// The carried load in one frame. Camera frame, metres.
struct CarriedLoad {
  LoadSource source = LoadSource::Scene;  ///< who gives it; never Auto
  std::optional<OrientedBox> box;         ///< absent where it is not known
  /// Why this very frame does not show the load that is to be detected; None otherwise.
  LoadFault fault = LoadFault::None;
  std::optional<double> age;        ///< seconds since it was last seen; absent unless detected
  std::optional<ViewedBox> volume;  ///< `box` with the margin that is masked with it

  /// A load that is to be detected may be there, and is not seen.
  bool isMissed() const { return !box && source == LoadSource::Detected; }
};

/// Owns what is known of the load from earlier frames: its pose and sizes, and where on it the tool
/// holds it. Used by one thread.
class LoadStage {
 public:
  /// Detects the load at the tool and follows it, or takes it from the settings or the frame.
  CarriedLoad update(const Frame& frame, const SensedFrame& sensed, const ToolTrack& tool,
                     const Parameters& parameters);

  /// Where the load, extrapolated to `stamp` (seconds on the source's clock), has the tool. Absent
  /// when the load was not seen for `maxAge` seconds, or the grip is not known.
  std::optional<Eigen::Vector3f> heldToolPoint(double stamp, double maxAge) const;

  /// Forgets where the tool holds the load: the operator knows better where the tool is.
  void forgetGrip() { m_held.reset(); }

 private:
  CarriedLoad detect(const SensedFrame& sensed, double stamp, const ToolTrack& tool,
                     const Parameters& parameters);

  LoadFollower m_follower;
  HeldTool m_held;
};

}  // namespace boomwatch
