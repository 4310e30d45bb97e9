#include "pipeline/model_gate.h"

#include <utility>

#include "environment/cell_update.h"
#include "pipeline/load_source.h"

namespace boomwatch {

ModelGate::Decision ModelGate::decide(double stamp, const FrameChecks::Verdict& verdict,
                                      const ToolTrack& tool, const CarriedLoad& load,
                                      const StaticScene& scene, const Parameters& parameters) {
  Decision decision;
  const bool craneHeld = tool.point && std::exchange(m_craneInModel, false);
  decision.forget = craneHeld || verdict.modelIsStale;
  const bool maskFailed =
      noteMask(stamp, scene.toolMask, load.isMissed(), parameters.tracking.maxToolAge);
  decision.update = chainFault(verdict, tool) == Reason::None && !maskFailed;
  if (decision.update) {
    countWithheld(scene.maybeLoad, parameters.model);
    m_craneInModel = m_craneInModel || !isToolNamed(tool);
  }
  decision.modelFault = m_framesWithheld > 0 ? Reason::NoModel : Reason::None;
  return decision;
}

/// Whether the crane is unmasked, and not yet for longer than `maxAge` seconds. A leaf before the
/// tool does that for a moment: boom and load would enter the model. A tool on the ground does it
/// for long, and then warning of the crane is better than a model that stands still.
bool ModelGate::noteMask(double stamp, ToolMask mask, bool loadMissed, double maxAge) {
  if (mask != ToolMask::TooLarge && mask != ToolMask::NothingThere) {
    m_unmaskedSince.reset();
  } else if (!m_unmaskedSince || stamp < *m_unmaskedSince || loadMissed) {
    // Without a load the time does not run. The tracker has most likely lost its way, and when it
    // is back the load would be in the middle of the crane that the model had taken up.
    m_unmaskedSince = stamp;
  }
  return m_unmaskedSince && stamp - *m_unmaskedSince <= maxAge;
}

/// The model did not see what may have been a load. When a load is found after all, or the tool is
/// watched from now on, the rest of that is environment: it needs its time to enter.
void ModelGate::countWithheld(std::size_t maybeLoad, const ModelParameters& parameters) {
  if (maybeLoad > 0) {
    m_framesWithheld = framesToEnter(parameters).value_or(0);
  } else if (m_framesWithheld > 0) {
    --m_framesWithheld;
  }
}

}  // namespace boomwatch
