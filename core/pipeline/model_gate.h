#pragma once

#include <optional>

#include "crane/static_scene.h"
#include "pipeline/frame_checks.h"
#include "pipeline/load_stage.h"

namespace boomwatch {

/// Decides from frame to frame what may change the environment model. Used by one thread.
class ModelGate {
 public:
  struct Decision {
    bool forget = false;  ///< the model holds no more: begin a new one, before any update
    bool update = false;  ///< this frame may update the model
    /// NoModel while the model lacks what was withheld from it as a possible load; else None.
    Reason modelFault = Reason::None;
  };

  /// Once a frame, with what the earlier stages made of it. `stamp`: seconds on the source's clock.
  ///
  /// - An invalid frame, or one without the tool that is tracked, does not update the model.
  /// - Nor does one in which the crane could not be masked, for up to max_tool_age. After that it
  ///   does, unless no load is seen either: then the tracker is most likely on something else.
  /// - The model is forgotten when `verdict` says so, and when the tool's place becomes known after
  ///   frames without it: until then the model took the crane for an obstacle.
  Decision decide(double stamp, const FrameChecks::Verdict& verdict, const ToolTrack& tool,
                  const CarriedLoad& load, const StaticScene& scene, const Parameters& parameters);

 private:
  bool noteMask(double stamp, ToolMask mask, bool loadMissed, double maxAge);
  void countWithheld(std::size_t maybeLoad, const ModelParameters& parameters);

  std::optional<double> m_unmaskedSince;  ///< stamp of the first frame with the crane unmasked
  bool m_craneInModel = false;            ///< frames without a named tool have updated the model
  int m_framesWithheld = 0;  ///< updates until the model holds what could have been the load
};

}  // namespace boomwatch
