#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace boomwatch {

/// The whole of an ordinary file. Throws Error naming it when it is absent, not an ordinary file (a
/// pipe or a device could keep the reader for ever), empty, longer than `limit` bytes, or
/// unreadable.
std::string readFileBytes(const std::filesystem::path& file, std::size_t limit);

/// Writes `bytes` to `file`, all or nothing: they go to a file beside it that then takes its place.
/// A link stays a link: what it points to is replaced. False when it could not be done; what was
/// there is then as it was.
bool replaceFile(const std::filesystem::path& file, const std::string& bytes);

}  // namespace boomwatch
