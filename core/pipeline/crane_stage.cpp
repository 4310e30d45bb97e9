#include "pipeline/crane_stage.h"

namespace boomwatch {

StaticScene CraneStage::separate(SegmentedCloud segments, const Frame& frame,
                                 const SensedFrame& sensed, const ToolTrack& tool,
                                 const CarriedLoad& load, const Parameters& parameters) {
  m_memory.forgetBefore(frame.stamp);
  // Where tool or boom are watched, objects near them must not be missing from the model.
  const bool unseenLoad = load.isMissed() && !parameters.watch.tool && !parameters.watch.boom;
  StaticScene scene = separateStatic(std::move(segments), *sensed.cloud, tool.point, load.volume,
                                     parameters, m_memory, unseenLoad);
  m_memory.note(frame.stamp, scene.toolCluster);
  m_memory.note(frame.stamp, scene.boomCut);
  return scene;
}

}  // namespace boomwatch
