#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace boomwatch {

/// A chunk of a bag larger than this, in bytes, is not read: a few kilobytes can claim any size.
inline constexpr std::size_t maxChunk = std::size_t(256) << 20;

/// The `size` bytes that `packed` holds, by the method named as bags name it: "" or "none", "bz2",
/// "lz4" (a frame), "zstd". Absent when it is damaged, has another size, the size is above
/// maxChunk, or the method is none of these. Any thread.
std::optional<std::string> decompress(std::string_view method, std::string_view packed,
                                      std::size_t size);

}  // namespace boomwatch
