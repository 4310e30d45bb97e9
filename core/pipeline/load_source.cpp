#include "pipeline/load_source.h"

#include "collision/nearest_pair.h"

namespace boomwatch {

bool isToolNamed(const Result& result) { return result.tool.running() || result.tool.pixel; }

LoadSource loadSource(const Result& result) {
  const LoadSource wanted = result.parameters.load.source;
  if (wanted != LoadSource::Auto) return wanted;
  // Also where a source that has a crane knows the load: as long as nobody says where the tool is,
  // the crane stays in the cloud, and the load touches what holds it.
  const bool hasTool = result.tool.running() || result.frame->tool;
  return hasTool ? LoadSource::Detected : LoadSource::Scene;
}

Reason loadReason(const Result& result) {
  const std::optional<OrientedBox>& load = result.load;
  const Bounds& bounds = result.parameters.bounds;
  if (!load && loadSource(result) == LoadSource::Detected) {
    return isToolNamed(result) ? Reason::LoadNotSeen : Reason::NoTool;
  }
  if (!load || !isUsable(*load)) return Reason::NoLoad;
  return bounds.contains(load->centre.cast<float>()) ? Reason::None : Reason::LoadOutside;
}

}  // namespace boomwatch
