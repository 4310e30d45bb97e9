#include "sources/bag/decompress.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <memory>

namespace boomwatch {
namespace {

bool unpackBz2(std::string_view packed, std::string& out) {
  auto size = static_cast<unsigned>(out.size());
  // bzlib takes what it only reads as not const.
  const int result = BZ2_bzBuffToBuffDecompress(out.data(), &size, const_cast<char*>(packed.data()),
                                                static_cast<unsigned>(packed.size()), 0, 0);
  return result == BZ_OK && size == out.size();
}

bool unpackLz4(std::string_view packed, std::string& out) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION))) return false;
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      raw, &LZ4F_freeDecompressionContext);
  std::size_t read = 0, written = 0;
  while (read < packed.size()) {
    std::size_t in = packed.size() - read, room = out.size() - written;
    const std::size_t hint = LZ4F_decompress(context.get(), out.data() + written, &room,
                                             packed.data() + read, &in, nullptr);
    if (LZ4F_isError(hint) || (in == 0 && room == 0)) return false;
    read += in;
    written += room;
    if (hint == 0) break;
  }
  return written == out.size();
}

bool unpackZstd(std::string_view packed, std::string& out) {
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
  return !ZSTD_isError(size) && size == out.size();
}

}  // namespace

std::optional<std::string> decompress(std::string_view method, std::string_view packed,
                                      std::size_t size) {
  if (size > maxChunk || packed.size() > maxChunk) return std::nullopt;
  if (method.empty() || method == "none") {
    if (packed.size() != size) return std::nullopt;
    return std::string(packed);
  }
  std::string out(size, '\0');
  const bool whole = method == "bz2"    ? unpackBz2(packed, out)
                     : method == "lz4"  ? unpackLz4(packed, out)
                     : method == "zstd" ? unpackZstd(packed, out)
                                        : false;
  if (!whole) return std::nullopt;
  return out;
}

}  // namespace boomwatch
