#pragma once

#include <filesystem>
#include <memory>

#include "sources/bag/bag_file.h"

namespace boomwatch {

/// An MCAP file, of ROS 2, ROS 1 or in JSON. See openBagFile(). Throws Error.
std::unique_ptr<BagFile> openMcapBag(const std::filesystem::path& file);

}  // namespace boomwatch
