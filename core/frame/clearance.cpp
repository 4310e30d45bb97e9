#include "frame/clearance.h"

namespace boomwatch {

std::string_view toString(Reason reason) {
  switch (reason) {
    case Reason::None:
      return "";
    case Reason::NoFrame:
      return "no_frame";
    case Reason::UnreadableFrame:
      return "unreadable_frame";
    case Reason::IdenticalFrames:
      return "identical_frames";
    case Reason::FewDepthPixels:
      return "few_depth_pixels";
    case Reason::SceneMoves:
      return "scene_moves";
    case Reason::ToolLost:
      return "tool_lost";
    case Reason::NoTool:
      return "no_tool";
    case Reason::NoLoad:
      return "no_load";
    case Reason::LoadNotSeen:
      return "load_not_seen";
    case Reason::LoadOutside:
      return "load_outside_bounds";
    case Reason::ToolNotSeen:
      return "tool_not_seen";
    case Reason::NoModel:
      return "no_model_yet";
    case Reason::SearchTooShort:
      return "search_too_short";
    case Reason::NothingObserved:
      return "nothing_observed";
  }
  return "";
}

std::string_view toString(LoadPart part) {
  switch (part) {
    case LoadPart::Inside:
      return "inside";
    case LoadPart::Face:
      return "face";
    case LoadPart::Edge:
      return "edge";
    case LoadPart::Corner:
      return "corner";
  }
  return "";
}

std::string_view toString(ClearanceState state) {
  switch (state) {
    case ClearanceState::Measured:
      return "measured";
    case ClearanceState::NothingInRange:
      return "nothing_in_range";
    case ClearanceState::Unknown:
      return "unknown";
  }
  return "";
}

}  // namespace boomwatch
