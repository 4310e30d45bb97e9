#include "sources/bag/chunked_bag.h"

#include <algorithm>

#include "base/error.h"
#include "sources/bag/decompress.h"

namespace boomwatch {
namespace {

// Left, right and their neighbours in time.
constexpr std::size_t chunksKept = 4;

}  // namespace

ChunkedBag::ChunkedBag(const std::filesystem::path& file) : m_stream(file, std::ios::binary) {
  std::error_code fault;
  m_size = std::filesystem::file_size(file, fault);
  if (fault || !m_stream) throw Error(file.string(), "it cannot be read", "Check its permissions.");
}

std::optional<std::string> ChunkedBag::bytesAt(std::uint64_t place, std::uint64_t count) {
  if (place > m_size || count > m_size - place || count > maxChunk) return std::nullopt;
  std::string bytes(static_cast<std::size_t>(count), '\0');
  m_stream.clear();
  m_stream.seekg(static_cast<std::streamoff>(place));
  m_stream.read(bytes.data(), static_cast<std::streamsize>(count));
  if (!m_stream) return std::nullopt;
  return bytes;
}

const std::string* ChunkedBag::chunkAt(std::uint64_t place) {
  const auto known = std::ranges::find(m_recent, place, [](const auto& one) { return one.first; });
  if (known != m_recent.end()) {
    m_recent.splice(m_recent.begin(), m_recent, known);
  } else {
    if (m_recent.size() >= chunksKept) m_recent.pop_back();
    m_recent.emplace_front(place, readChunk(place));
  }
  const auto& chunk = m_recent.front().second;
  return chunk ? &*chunk : nullptr;
}

void ChunkedBag::finish(std::uint64_t damagedChunks, bool isCut) {
  std::ranges::stable_sort(m_messages, {}, &BagMessage::time);
  if (damagedChunks > 0) m_damage = std::to_string(damagedChunks) + " damaged chunks are left out";
  if (isCut)
    m_damage += std::string(m_damage.empty() ? "" : ", and ") + "the file is cut at its end";
}

}  // namespace boomwatch
