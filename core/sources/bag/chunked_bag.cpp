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
    if (!m_recent.front().second) m_damaged.insert(place);
  }
  const auto& chunk = m_recent.front().second;
  return chunk ? &*chunk : nullptr;
}

void ChunkedBag::beginChunk(std::uint64_t place) {
  endChunk();
  m_chunks.push_back(place);
  m_isIndexed = false;
}

std::optional<std::uint64_t> ChunkedBag::indexedChunk() {
  if (m_chunks.empty()) return std::nullopt;
  m_isIndexed = true;
  return m_chunks.back();
}

void ChunkedBag::endChunk() {
  if (!m_isIndexed) walkChunk(m_chunks.back(), true);
  m_isIndexed = true;
}

std::size_t ChunkedBag::topicOf(std::uint32_t id) {
  const auto [found, isNew] = m_topicOf.try_emplace(id, m_topics.size());
  if (isNew) m_topics.emplace_back();
  return found->second;
}

void ChunkedBag::addMessage(const BagMessage& message) {
  if (message.time >= 0) m_messages.push_back(message);
}

void ChunkedBag::finish(bool isCut) {
  endChunk();
  if (isCut && !m_chunks.empty()) {  // a part of the last chunk's index may be missing
    const std::uint64_t last = m_chunks.back();
    std::erase_if(m_messages, [&](const BagMessage& message) { return message.place == last; });
    walkChunk(last, true);
  }
  const auto isNameless = [](const BagTopic& topic) { return topic.name.empty(); };
  // A file that was not closed has the names in its chunks alone.
  if (std::ranges::any_of(m_topics, isNameless)) {
    for (const std::uint64_t chunk : m_chunks) walkChunk(chunk, false);
  }
  std::erase_if(m_messages, [&](const BagMessage& m) { return isNameless(m_topics[m.topic]); });
  std::ranges::stable_sort(m_messages, {}, &BagMessage::time);
  if (!m_damaged.empty()) {
    m_damage = std::to_string(m_damaged.size()) + " damaged chunks are left out";
  }
  if (isCut) m_damage += (m_damage.empty() ? "" : ", and ") + std::string("its end is missing");
}

}  // namespace boomwatch
