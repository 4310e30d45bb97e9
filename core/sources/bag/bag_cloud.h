#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "frame/cloud.h"
#include "sources/bag/bag_file.h"

namespace boomwatch {

/// In which frame the points of a message are, as its header names it.
std::string cloudFrameIn(const BagTopic& topic, std::string_view bytes);

/// The points of a sensor_msgs/PointCloud2 message: fields x, y, z as 32- or 64-bit floats in any
/// order, organised or not. Absent when the message is damaged, has no such fields, or more than
/// maxImage points. The camera is left to the caller. Never throws.
std::optional<Cloud> decodeCloud(const BagTopic& topic, std::string_view bytes);

}  // namespace boomwatch
