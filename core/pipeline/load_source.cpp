#include "pipeline/load_source.h"

#include "collision/nearest_pair.h"

namespace boomwatch {

bool isToolNamed(const ToolTrack& tool) { return tool.running() || tool.pixel; }

LoadSource loadSource(LoadSource wanted, const Frame& frame, const ToolTrack& tool) {
  if (wanted != LoadSource::Auto) return wanted;
  // A scene's own load would do only without a crane. Until the tool is known the crane stays in
  // the cloud, and the load touches the tool that holds it.
  return tool.running() || frame.tool ? LoadSource::Detected : LoadSource::Scene;
}

Reason loadReason(const std::optional<OrientedBox>& load, LoadSource source, const ToolTrack& tool,
                  const Bounds& bounds) {
  if (!load && source == LoadSource::Detected) {
    return isToolNamed(tool) ? Reason::LoadNotSeen : Reason::NoTool;
  }
  if (!load || !isUsable(*load)) return Reason::NoLoad;
  return bounds.contains(load->centre.cast<float>()) ? Reason::None : Reason::LoadOutside;
}

}  // namespace boomwatch
