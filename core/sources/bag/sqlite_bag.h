#pragma once

#include <filesystem>
#include <memory>

#include "sources/bag/bag_file.h"

namespace boomwatch {

/// A ROS 2 bag in sqlite, opened for reading alone; the log beside it (-wal) is read as well. See
/// openBagFile(). Throws Error.
std::unique_ptr<BagFile> openSqliteBag(const std::filesystem::path& file);

}  // namespace boomwatch
