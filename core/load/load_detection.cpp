#include "load/load_detection.h"

namespace boomwatch {

std::string_view toString(LoadFault fault) {
  switch (fault) {
    case LoadFault::None:
      return "";
    case LoadFault::NoToolPoint:
      return "no_tool_point";
    case LoadFault::NothingAtTool:
      return "nothing_at_tool";
    case LoadFault::OnSurface:
      return "on_surface";
    case LoadFault::NoBody:
      return "no_body";
    case LoadFault::EndOn:
      return "end_on";
    case LoadFault::EndHidden:
      return "end_hidden";
    case LoadFault::DepthHidden:
      return "depth_hidden";
    case LoadFault::FewPoints:
      return "few_points";
    case LoadFault::PoorFit:
      return "poor_fit";
    case LoadFault::TooLarge:
      return "too_large";
    case LoadFault::OutsideBounds:
      return "outside_bounds";
  }
  return "";
}

}  // namespace boomwatch
