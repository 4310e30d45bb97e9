#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "sources/bag/bag_file.h"

namespace boomwatch {

/// A bag file, or ROS 2's folder of them: its files in natural order as one bag. Throws Error.
std::unique_ptr<BagFile> openBagPath(const std::filesystem::path& path);

/// "FILE,left=/a,right=/b" -> the file and the option. A comma may stand in the file's own name:
/// the option begins with the first of its keys.
std::pair<std::filesystem::path, std::string> splitBagPath(const std::string& path);

/// Whether the name ends as a bag's does: .bag, .mcap or .db3. Any thread.
bool isBagFile(const std::filesystem::path& file);

}  // namespace boomwatch
