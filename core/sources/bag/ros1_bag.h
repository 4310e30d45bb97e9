#pragma once

#include <filesystem>
#include <memory>

#include "sources/bag/bag_file.h"

namespace boomwatch {

/// A ROS 1 bag, format 2.0. See openBagFile(). Throws Error.
std::unique_ptr<BagFile> openRos1Bag(const std::filesystem::path& file);

}  // namespace boomwatch
