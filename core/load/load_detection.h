#pragma once

#include <optional>
#include <string_view>

#include "frame/oriented_box.h"

namespace boomwatch {

/// Why no load was found in one frame. `None` when one was.
enum class LoadFault {
  None,
  NoToolPoint,    ///< nobody said where the tool is, or nothing was measured there
  NothingAtTool,  ///< the cloud has no surface at the tool point
  OnSurface,      ///< what is at the tool is the ground or a wall: it extends too far
  NoBody,         ///< nothing reaches beyond the tool as a load would: an empty tool and its boom
  EndOn,          ///< it points at the camera, so that its length cannot be seen
  EndHidden,      ///< an end is hidden or out of the picture, and the length is not locked
  DepthHidden,    ///< one face is all that is seen of a box, and its sizes are not locked
  FewPoints,      ///< too few points on it
  PoorFit,        ///< its points are not those of such a body
  TooLarge,       ///< larger than load_max_size
  OutsideBounds,  ///< its centre is not inside the bounds
};

/// Stable name for files and logs, e.g. "no_body"; "" for None.
std::string_view toString(LoadFault fault);

/// What one frame shows of the load.
struct LoadDetection {
  std::optional<OrientedBox> box;  ///< camera frame; a log's axis is the box's x. Absent on a fault
  LoadFault fault = LoadFault::NoToolPoint;
  bool isWhole = true;  ///< its sizes were seen, not taken over from what was known of it

  static LoadDetection refused(LoadFault why) { return {{}, why, false}; }
};

}  // namespace boomwatch
