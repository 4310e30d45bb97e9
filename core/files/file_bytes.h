#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace boomwatch {

/// The whole of an ordinary file. Throws Error naming it when it is absent, not an ordinary file (a
/// pipe or a device could keep the reader for ever), empty, longer than `limit` bytes, or
/// unreadable.
std::string readFileBytes(const std::filesystem::path& file, std::size_t limit);

}  // namespace boomwatch
