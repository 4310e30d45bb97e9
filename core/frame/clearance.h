#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

namespace boomwatch {

/// Why there is no distance. One list for the whole chain; `None` when there is one.
enum class Reason {
  None,
  NoFrame,          ///< nothing has arrived for longer than max_frame_age
  UnreadableFrame,  ///< the source could not read this frame
  IdenticalFrames,  ///< the source repeats one picture: a pulled cable, a frozen camera
  FewDepthPixels,   ///< less than min_fill of the cloud was measured
  SceneMoves,       ///< the picture moves as a whole: the camera is not still
  ToolLost,         ///< a tracker runs, and has not known for max_tool_age where the tool is
  NoTool,           ///< the load is to be detected, and nobody said where the tool is
  NoLoad,           ///< nobody said where the load is
  LoadNotSeen,      ///< it is to be detected, and was not for longer than max_load_age
  LoadOutside,      ///< the load is not inside the bounds
  ToolNotSeen,      ///< tool or boom are watched, but not found in the cloud
  NoModel,          ///< too few frames yet for anything to enter the model (Eq. 22-23)
  SearchTooShort,   ///< nothing found, but the search ends before the caution distance
  NothingObserved,  ///< less than min_observed of the load's neighbourhood was ever seen
};

/// Stable name for files and logs, e.g. "few_depth_pixels"; "" for None.
std::string_view toString(Reason reason);

/// The part of the load that is nearest.
enum class LoadPart { Inside, Face, Edge, Corner };
/// Stable name for files and logs.
std::string_view toString(LoadPart part);

/// Both ends of the shortest line, and how far apart they are. Camera frame, metres.
struct Nearest {
  double distance = 0.0;  ///< 0: the environment is inside the load's volume
  Eigen::Vector3d onLoad = Eigen::Vector3d::Zero();  ///< witness point on the load
  Eigen::Vector3d onEnvironment =
      Eigen::Vector3d::Zero();  ///< witness point on the model: the centre of a cell's surface
  LoadPart part = LoadPart::Inside;
  /// Largest error, +-, that the size of a cell and of a depth level alone can cause.
  double quantisation = 0.0;
  /// It is space that was never seen, and taken for solid (unknown_space), that is nearest.
  bool unseen = false;
};

/// What stands behind the nearest point: the connected piece of the model that it belongs to. A
/// lone cell counts less than the ground.
struct Evidence {
  int cells = 0;             ///< occupied cells of the piece
  double area = 0.0;         ///< of them, square metres across the line of sight
  double extent = 0.0;       ///< diagonal of the piece's bounding box, metres
  double probability = 0.0;  ///< mean over its cells
  /// Of a collision there, 0..1: the probability as a share of the highest that the update can
  /// reach, times how large the piece is, 1 - exp(-area / (20 cm)^2).
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

/// How far the load is from the nearest thing, or why that is not known. Never a number that is
/// not a distance: `nearest` is set if and only if `state` is Measured.
struct Clearance {
  ClearanceState state = ClearanceState::Unknown;
  Reason reason = Reason::NoFrame;  ///< None unless Unknown
  std::optional<Nearest> nearest;
  /// Share of the searched neighbourhood (every cell in which something nearer than the reported
  /// distance could be; what lies outside the bounds counts as unobserved) that was ever observed.
  std::optional<double> observedShare;
  std::optional<Evidence> evidence;  ///< set with `nearest`, unless that is unseen space
  std::vector<SearchRay> rays;       ///< filled by the `rays` method only

  static Clearance unknown(Reason why) { return {ClearanceState::Unknown, why, {}, {}, {}, {}}; }
};

}  // namespace boomwatch
