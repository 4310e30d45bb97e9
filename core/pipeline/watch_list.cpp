#include "pipeline/watch_list.h"

#include "crane/crane_boxes.h"
#include "pipeline/load_source.h"

namespace boomwatch {
namespace {

CraneBoxes craneBoxesOf(const WatchInput& input, double toolSize) {
  if (!input.tool.point || input.scene.toolMask != ToolMask::Taken) return {};
  CraneBoxes crane =
      craneBoxes(input.scene.toolCluster, *input.tool.point, toolSize, input.load.volume);
  const auto cut = boomSegments(input.scene.boomCut);
  crane.boom.insert(crane.boom.end(), cut.begin(), cut.end());
  return crane;
}

}  // namespace

WatchList watchList(const WatchInput& input, const WatchedEnvironment& environment,
                    const Parameters& parameters) {
  WatchList list;
  if (input.fault != Reason::None) {
    list.clearance = Clearance::unknown(input.fault);
    return list;
  }
  const auto add = [&](WatchedObject object, int segment, const std::optional<OrientedBox>& box,
                       Reason fault) {
    if (fault == Reason::None) fault = input.modelFault;
    const Clearance clearance = fault == Reason::None ? environment.clearanceOf(*box, parameters)
                                                      : Clearance::unknown(fault);
    list.watched.push_back({object, segment, box, clearance});
  };
  const WatchParameters& watch = parameters.watch;
  if (watch.load) {
    add(WatchedObject::Load, 0, input.load.box,
        loadReason(input.load.box, input.load.source, input.tool, parameters.bounds));
  }
  if (watch.tool || watch.boom) {
    const CraneBoxes crane = craneBoxesOf(input, parameters.load.toolSize);
    const auto reason = [](bool isSeen) { return isSeen ? Reason::None : Reason::ToolNotSeen; };
    if (watch.tool) add(WatchedObject::Tool, 0, crane.tool, reason(crane.tool.has_value()));
    if (watch.boom && crane.boom.empty()) {
      add(WatchedObject::Boom, 0, std::nullopt, reason(false));
    }
    int segment = 0;
    for (const OrientedBox& box : crane.boom) {
      if (watch.boom) add(WatchedObject::Boom, ++segment, box, Reason::None);
    }
  }
  list.leading = leadingOf(list.watched, parameters.warning);
  list.clearance = list.watched[list.leading].clearance;
  return list;
}

}  // namespace boomwatch
