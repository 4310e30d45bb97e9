#pragma once

#include <vector>

#include "crane/static_scene.h"
#include "pipeline/load_stage.h"
#include "pipeline/watched.h"
#include "pipeline/watched_environment.h"

namespace boomwatch {

/// All that is watched in one frame, with the distance of each.
struct WatchList {
  std::vector<Watched> watched;  ///< the load first; empty if the frame gives no distance at all
  std::size_t leading = 0;       ///< index into `watched` of the one that leads (see leadingOf)
  Clearance clearance;           ///< of that one or, with an empty list, the reason

  bool isLoadLeading() const {
    return !watched.empty() && watched[leading].object == WatchedObject::Load;
  }
};

/// What earlier stages made of a frame, as far as the distances depend on it.
struct WatchInput {
  Reason fault;       ///< why the frame gives no distance at all (see chainFault); else None
  Reason modelFault;  ///< why the model cannot be searched (see ModelGate); else None
  const ToolTrack& tool;
  const CarriedLoad& load;
  const StaticScene& scene;
};

/// The distance of load, tool and boom, those of them that `parameters.watch` names. Pure.
WatchList watchList(const WatchInput& input, const WatchedEnvironment& environment,
                    const Parameters& parameters);

}  // namespace boomwatch
