#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

namespace boomwatch {

/// Why there is no distance. One list for the whole pipeline; `None` when there is a distance.
enum class Reason {
  None,
  NoFrame,          ///< no frame arrived for longer than max_frame_age
  UnreadableFrame,  ///< the source could not read this frame
  IdenticalFrames,  ///< the source repeats the same picture: pulled cable, frozen camera
  FewDepthPixels,   ///< less than min_fill of the cloud has a depth
  SceneMoves,       ///< the whole picture moves, so the camera moves
  ToolLost,         ///< the tracker has lost the tool for longer than max_tool_age
  NoTool,           ///< the load is to be detected, but no tool is selected
  NoLoad,           ///< the position of the load is not set
  LoadNotSeen,      ///< the load was not detected for longer than max_load_age
  LoadOutside,      ///< the load is outside the bounds
  ToolNotSeen,      ///< tool or boom is watched, but was not found in the cloud
  NoModel,          ///< too few frames for an object to enter the model (Eq. 22-23)
  SearchTooShort,   ///< no obstacle found, but the search ends before the caution distance
  NothingObserved,  ///< less than min_observed of the load's neighbourhood was observed
};

/// Stable name for files and logs, e.g. "few_depth_pixels"; "" for None.
std::string_view toString(Reason reason);

/// The part of the load that is nearest.
enum class LoadPart { Inside, Face, Edge, Corner };
/// Stable name for files and logs.
std::string_view toString(LoadPart part);

/// The shortest distance and its two witness points. Camera frame, metres.
struct Nearest {
  double distance = 0.0;  ///< 0: the environment is inside the load's volume
  Eigen::Vector3d onLoad = Eigen::Vector3d::Zero();  ///< witness point on the load
  Eigen::Vector3d onEnvironment =
      Eigen::Vector3d::Zero();  ///< witness point on the model: the centre of a cell's surface
  LoadPart part = LoadPart::Inside;
  /// Maximum error, +-, caused by the size of a cell and of a depth level.
  double quantisation = 0.0;
  /// The nearest obstacle is unobserved space, which unknown_space treats as solid.
  bool unseen = false;
};

/// The connected component of the model to which the nearest point belongs. A single cell is weaker
/// evidence than the ground.
struct Evidence {
  int cells = 0;             ///< occupied cells of the component
  double area = 0.0;         ///< of these cells, square metres across the line of sight
  double extent = 0.0;       ///< diagonal of the bounding box, metres
  double probability = 0.0;  ///< mean over its cells
  /// Confidence of a collision there, 0..1: the probability as a share of the maximum of the update
  /// rule, times 1 - exp(-area / (20 cm)^2).
  double confidence = 0.0;
};

/// A search ray of the thesis, for drawing. Camera frame, metres. Source: docs/method.md section 7,
/// Eq. 14-19.
struct SearchRay {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

enum class ClearanceState { Measured, NothingInRange, Unknown };
/// Stable name for files and logs.
std::string_view toString(ClearanceState state);

/// The distance from the load to the nearest obstacle, or the reason why it is unknown. `nearest`
/// is set if and only if `state` is Measured.
struct Clearance {
  ClearanceState state = ClearanceState::Unknown;
  Reason reason = Reason::NoFrame;  ///< None unless Unknown
  std::optional<Nearest> nearest;
  /// Observed share of the neighbourhood, 0..1. The neighbourhood is every cell that could hold an
  /// obstacle nearer than the reported distance. Cells outside the bounds are unobserved.
  std::optional<double> observedShare;
  std::optional<Evidence> evidence;  ///< set with `nearest`, unless that is unobserved space
  std::vector<SearchRay> rays;       ///< filled by the `rays` method only

  static Clearance unknown(Reason why) { return {ClearanceState::Unknown, why, {}, {}, {}, {}}; }
};

}  // namespace boomwatch
