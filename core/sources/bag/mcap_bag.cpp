#include "sources/bag/mcap_bag.h"

#include <map>
#include <set>
#include <string_view>

#include "base/error.h"
#include "sources/bag/byte_cursor.h"
#include "sources/bag/chunked_bag.h"
#include "sources/bag/decompress.h"

namespace boomwatch {
namespace {

// Kinds of records, by their first byte.
enum Op : std::uint8_t { Footer = 2, Schema = 3, Channel = 4, Message = 5, Chunk = 6, Index = 7 };

constexpr std::uint64_t signature = 8;
constexpr std::uint64_t recordHead = 9;  // the kind and the length

BagEncoding encodingOf(std::string_view message) {
  if (message == "cdr") return BagEncoding::Cdr;
  if (message == "ros1") return BagEncoding::Ros1;
  if (message == "json") return BagEncoding::Json;
  return BagEncoding::Other;
}

class McapBag : public ChunkedBag {
 public:
  explicit McapBag(const std::filesystem::path& file) : ChunkedBag(file) {
    walkFile();
    if (!m_unknown.empty()) {
      for (const std::uint64_t chunk : m_chunks) walkChunk(chunk, false);
    }
    for (const auto& [topic, schema] : m_schemaOf) {
      if (const auto name = m_schemas.find(schema); name != m_schemas.end()) {
        m_topics[topic].type = withoutMsg(name->second);
      }
    }
    std::erase_if(m_messages,
                  [this](const BagMessage& m) { return m_topics[m.topic].name.empty(); });
    finish(m_damaged.size(), m_isCut);
  }

  std::optional<std::string> read(const BagMessage& message) override {
    std::optional<std::string> loose;
    std::string_view record;
    if (message.place == 0) {  // outside all chunks
      const auto head = bytesAt(message.offset, recordHead);
      if (!head) return std::nullopt;
      ByteCursor cursor(std::string_view(*head).substr(1));
      loose = bytesAt(message.offset + recordHead, cursor.number<std::uint64_t>());
      if (!loose) return std::nullopt;
      record = *loose;
    } else {
      const std::string* chunk = chunkAt(message.place);
      if (!chunk || message.offset > chunk->size()) return std::nullopt;
      ByteCursor cursor(std::string_view(*chunk).substr(message.offset));
      cursor.number<std::uint8_t>();
      record = cursor.take(cursor.number<std::uint64_t>());
    }
    constexpr std::size_t messageHead = 22;  // channel, sequence, two times
    if (record.size() < messageHead) return std::nullopt;
    return std::string(record.substr(messageHead));
  }

 private:
  void walkFile() {
    std::uint64_t place = signature;
    bool indexed = true;
    const auto walkLast = [&] {
      if (!indexed) walkChunk(m_chunks.back(), true);
    };
    m_isCut = true;  // until the footer is found
    while (true) {
      const auto head = bytesAt(place, recordHead);
      if (!head) break;
      ByteCursor cursor(*head);
      const auto op = cursor.number<std::uint8_t>();
      const auto size = cursor.number<std::uint64_t>();
      const std::uint64_t data = place + recordHead;
      if (size > fileSize() - data) break;
      if (op == Index) {
        indexed = takeIndex(bytesAt(data, size)) || indexed;
      } else {
        walkLast();
        indexed = true;
      }
      if (op == Chunk) {
        m_chunks.push_back(place);
        indexed = false;
      } else if (op == Schema || op == Channel || op == Message) {
        if (const auto bytes = bytesAt(data, size)) takeRecord(op, *bytes, 0, place, true);
      } else if (op == Footer) {
        m_isCut = false;
        break;
      }
      place = data + size;
    }
    walkLast();
  }

  void takeRecord(std::uint8_t op, std::string_view bytes, std::uint64_t chunk,
                  std::uint64_t offset, bool withMessages) {
    ByteCursor cursor(bytes);
    const auto id = cursor.number<std::uint16_t>();
    if (op == Schema) m_schemas[id] = cursor.counted();
    if (op == Channel) takeChannel(id, cursor);
    if (op != Message || !withMessages) return;
    cursor.number<std::uint32_t>();
    const auto time = static_cast<std::int64_t>(cursor.number<std::uint64_t>());
    if (!cursor.failed()) m_messages.push_back({topicOf(id), time, chunk, offset});
  }

  void takeChannel(std::uint16_t id, ByteCursor& cursor) {
    const std::size_t topic = topicOf(id);
    m_schemaOf[topic] = cursor.number<std::uint16_t>();
    m_topics[topic].name = cursor.counted();
    m_topics[topic].encoding = encodingOf(cursor.counted());
    if (!m_topics[topic].name.empty()) m_unknown.erase(topic);
  }

  std::size_t topicOf(std::uint16_t channel) {
    const auto [found, isNew] = m_channels.try_emplace(channel, m_topics.size());
    if (isNew) {
      m_topics.emplace_back();
      m_unknown.insert(found->second);
    }
    return found->second;
  }

  // The times and offsets of one channel's messages in the chunk before it.
  bool takeIndex(const std::optional<std::string>& bytes) {
    if (!bytes || m_chunks.empty()) return false;
    ByteCursor cursor(*bytes);
    const std::size_t topic = topicOf(cursor.number<std::uint16_t>());
    for (ByteCursor entries(cursor.counted()); !entries.atEnd();) {
      const auto time = static_cast<std::int64_t>(entries.number<std::uint64_t>());
      const auto offset = entries.number<std::uint64_t>();
      if (!entries.failed()) m_messages.push_back({topic, time, m_chunks.back(), offset});
    }
    return true;
  }

  void walkChunk(std::uint64_t place, bool withMessages) {
    const std::string* chunk = chunkAt(place);
    if (!chunk) return;
    for (ByteCursor cursor(*chunk); !cursor.atEnd();) {
      const std::uint64_t offset = cursor.position();
      const auto op = cursor.number<std::uint8_t>();
      const std::string_view bytes = cursor.take(cursor.number<std::uint64_t>());
      if (!cursor.failed()) takeRecord(op, bytes, place, offset, withMessages);
    }
  }

  std::optional<std::string> readChunk(std::uint64_t place) override {
    auto chunk = unpack(place);
    if (!chunk) m_damaged.insert(place);
    return chunk;
  }

  std::optional<std::string> unpack(std::uint64_t place) {
    const auto head = bytesAt(place, recordHead);
    if (!head) return std::nullopt;
    ByteCursor length(std::string_view(*head).substr(1));
    const auto record = bytesAt(place + recordHead, length.number<std::uint64_t>());
    if (!record) return std::nullopt;
    ByteCursor cursor(*record);
    cursor.take(16);  // the times of its first and last message
    const auto size = cursor.number<std::uint64_t>();
    cursor.number<std::uint32_t>();  // a checksum
    const std::string_view method = cursor.counted();
    const std::string_view packed = cursor.take(cursor.number<std::uint64_t>());
    if (cursor.failed() || size > maxChunk) return std::nullopt;
    return decompress(method, packed, static_cast<std::size_t>(size));
  }

  std::map<std::uint16_t, std::size_t> m_channels;  // to topics
  std::map<std::size_t, std::uint16_t> m_schemaOf;  // of a topic
  std::map<std::uint16_t, std::string> m_schemas;
  std::set<std::size_t> m_unknown;  // topics of which no name was found so far
  std::vector<std::uint64_t> m_chunks;
  std::set<std::uint64_t> m_damaged;
  bool m_isCut = false;
};

}  // namespace

std::unique_ptr<BagFile> openMcapBag(const std::filesystem::path& file) {
  return std::make_unique<McapBag>(file);
}

}  // namespace boomwatch
