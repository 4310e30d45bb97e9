#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "collision/approach.h"
#include "crane/static_scene.h"
#include "environment/environment_model.h"
#include "frame/clearance.h"
#include "frame/frame.h"
#include "load/load_detection.h"
#include "pipeline/warning_level.h"
#include "pipeline/watched.h"
#include "tracking/tool_track.h"

namespace boomwatch {

/// How long one stage took.
struct StageTiming {
  std::string_view stage;  ///< "stereo", "filter", "model", "clearance", ...
  double milliseconds = 0.0;
};

/// All values that one frame led to, for panes and logs. Camera frame, metres, unless a field says
/// otherwise. Immutable once published; panes and logs share it between threads.
struct Result {
  FramePtr frame;                      ///< as the source gave it; absent with NoFrame
  cv::Mat image;                       ///< left, rectified: the picture the cloud belongs to
  std::shared_ptr<const Cloud> cloud;  ///< organised where the source is; absent with NoFrame
  double fill = 0.0;                   ///< share of the cloud that was measured
  ToolTrack tool;
  std::optional<OrientedBox> load;
  /// Why this very frame does not show the load that is to be detected; None otherwise.
  LoadFault loadFault = LoadFault::None;
  /// Seconds since the load was last seen; absent unless it is detected.
  std::optional<double> loadAge;
  std::optional<ViewedBox> loadVolume;  ///< `load` with the margin that is masked with it
  StaticScene scene;
  /// Share of the points inside the bounds that were masked as boom, tool and load. With a large
  /// share an obstacle may be among them.
  double removedShare = 0.0;
  Clearance clearance;           ///< of the object that leads or, with none watched, the reason
  std::vector<Watched> watched;  ///< the load first; empty if the frame gives no distance at all
  std::size_t leading = 0;       ///< index into `watched` of the one that `clearance` is taken from
  /// Indices of the model's cells that are occupied and not searched (smallest_thing,
  /// doubtful_thing).
  std::vector<std::size_t> suppressed;
  /// How the load moves. Absent without a distance, and until the load was seen for long enough.
  std::optional<Approach> approach;
  std::string message;  ///< English detail of a fault in this frame; empty if there was none
  WarningLevel level = WarningLevel::NoDistance;
  /// The depth error, +- metres, that a quarter of a pixel of disparity makes at the nearest point;
  /// absent unless the frame came from a calibrated stereo pair.
  std::optional<double> depthUncertainty;
  /// Row misalignment of the rectified pair, and the rest of it after correction, pixels (see
  /// StereoResult); absent as there.
  std::optional<double> rowResidue, rowsCorrected;
  bool modelRebuilt = false;  ///< this frame began a new model
  std::vector<StageTiming> timings;
  std::shared_ptr<const EnvironmentModel> model;  ///< a copy; absent unless asked for
  Parameters parameters;                          ///< those in force for this frame
};

using ResultPtr = std::shared_ptr<const Result>;

}  // namespace boomwatch
