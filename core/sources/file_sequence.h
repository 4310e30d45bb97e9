#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace boomwatch {

/// Whether `a` comes before `b` as people count: numbers by their value, "f9" before "f10".
bool naturalOrder(std::string_view a, std::string_view b);

/// The ordinary files of a folder that `wanted` accepts, in natural order of their names. Throws
/// Error naming the folder when it cannot be listed.
std::vector<std::filesystem::path> listFiles(
    const std::filesystem::path& folder,
    const std::function<bool(const std::filesystem::path&)>& wanted);

/// Seconds, where the name is obviously a time: "1305031102.175304" (seconds since 1970),
/// 16 or 19 digits (micro- or nanoseconds since 1970), or a date and time such as
/// "frame_20121214T142255.814212" (as if UTC). `stem` has no extension.
std::optional<double> stampFromName(std::string_view stem);

/// A stamp a file: from the names where every one is a time and they increase, otherwise
/// index / `rate`.
std::vector<double> stampsOf(const std::vector<std::filesystem::path>& files, double rate);

/// Frames a second, from the first stamp to the last; `otherwise` where they do not tell.
double meanRate(const std::vector<double>& stamps, double otherwise);

}  // namespace boomwatch
