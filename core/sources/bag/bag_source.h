#pragma once

#include <memory>
#include <string>

#include "sources/frame_source.h"

namespace boomwatch {

/// `bag:PATH[,TOPICS]`: a recording of ROS or Foxglove, a .bag (ROS 1), .mcap or .db3 file, or
/// ROS 2's folder of them. TOPICS as chooseTopics() takes them. Left and right, or depth and
/// colour, are paired by the stamps in their headers, at most half a period apart. The calibration
/// is options.calibration, or the bag's own camera_info. RealSense's own recordings name the unit
/// of their depth on a topic; other 16-bit depth is in millimetres.
///
/// Throws Error when the bag cannot be read or holds no such source. A message that cannot be read
/// gives Bad.
std::unique_ptr<FrameSource> openBagSource(const std::string& path, const std::string& address,
                                           const SourceOptions& options);

}  // namespace boomwatch
