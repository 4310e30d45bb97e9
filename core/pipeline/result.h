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

/// Milliseconds that one stage took.
struct StageTiming {
  std::string_view stage;  ///< "stereo", "filter", "model", "clearance", ...
  double milliseconds = 0.0;
};

/// What one frame led to: everything a pane or a log needs. Immutable once published.
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
  std::optional<ViewedBox> loadVolume;  ///< `load` with the margin that is taken out with it
  StaticScene scene;
  /// Share of the points inside the bounds that were taken out with boom, tool and load. Large:
  /// what is in the way may be among them.
  double removedShare = 0.0;
  Clearance clearance;           ///< of what leads or, where nothing is known, the reason
  std::vector<Watched> watched;  ///< all that is watched, the load first; empty if nothing is known
  std::size_t leading = 0;       ///< index into `watched` of the one that `clearance` is taken from
  /// Indices of the model's cells that are occupied but do not count (smallest_thing,
  /// doubtful_thing).
  std::vector<std::size_t> suppressed;
  /// How the load moves; absent until it was seen for long enough, and without a distance.
  std::optional<Approach> approach;
  std::string message;  ///< English detail of a fault in this frame; empty if there was none
  WarningLevel level = WarningLevel::NoDistance;
  /// The depth error, +- metres, that a quarter of a pixel of disparity makes at the nearest point;
  /// absent unless the frame came from a calibrated stereo pair.
  std::optional<double> depthUncertainty;
  /// How far the rows of a rectified pair differ by the calibration, and what is left of that where
  /// it is corrected, pixels (see StereoResult); absent as there.
  std::optional<double> rowResidue, rowsCorrected;
  bool modelRebuilt = false;  ///< the model was begun anew: its size changed
  std::vector<StageTiming> timings;
  std::shared_ptr<const EnvironmentModel> model;  ///< a copy; absent unless asked for
  Parameters parameters;                          ///< those in force for this frame
};

using ResultPtr = std::shared_ptr<const Result>;

}  // namespace boomwatch
