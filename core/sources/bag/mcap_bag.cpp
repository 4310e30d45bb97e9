#include "sources/bag/mcap_bag.h"

#include <map>
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
    const bool isCut = walkFile();
    finish(isCut);
    for (const auto& [topic, schema] : m_schemaOf) {
      if (const auto name = m_schemas.find(schema); name != m_schemas.end()) {
        m_topics[topic].type = withoutMsg(name->second);
      }
    }
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
  // True when the file is cut: it has no footer.
  bool walkFile() {
    for (std::uint64_t place = signature; const auto head = bytesAt(place, recordHead);) {
      ByteCursor cursor(*head);
      const auto op = cursor.number<std::uint8_t>();
      const auto size = cursor.number<std::uint64_t>();
      const std::uint64_t data = place + recordHead;
      if (size > fileSize() - data) return true;
      if (op == Index) {
        takeIndex(bytesAt(data, size));
      } else if (op == Chunk) {
        beginChunk(place);
      } else {
        endChunk();
      }
      if (op == Footer) return false;
      if (op == Schema || op == Channel || op == Message) {
        if (const auto bytes = bytesAt(data, size)) takeRecord(op, *bytes, 0, place, true);
      }
      place = data + size;
    }
    return true;
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
    if (!cursor.failed()) addMessage({topicOf(id), time, chunk, offset});
  }

  void takeChannel(std::uint16_t id, ByteCursor& cursor) {
    const std::size_t topic = topicOf(id);
    m_schemaOf[topic] = cursor.number<std::uint16_t>();
    m_topics[topic].name = cursor.counted();
    m_topics[topic].encoding = encodingOf(cursor.counted());
  }

  // The times and offsets of one channel's messages in the chunk before it.
  void takeIndex(const std::optional<std::string>& bytes) {
    const auto chunk = bytes ? indexedChunk() : std::nullopt;
    if (!chunk) return;
    ByteCursor cursor(*bytes);
    const std::size_t topic = topicOf(cursor.number<std::uint16_t>());
    for (ByteCursor entries(cursor.counted()); !entries.atEnd();) {
      const auto time = static_cast<std::int64_t>(entries.number<std::uint64_t>());
      const auto offset = entries.number<std::uint64_t>();
      if (!entries.failed()) addMessage({topic, time, *chunk, offset});
    }
  }

  void walkChunk(std::uint64_t place, bool withMessages) override {
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

  std::map<std::size_t, std::uint16_t> m_schemaOf;  // of a topic
  std::map<std::uint16_t, std::string> m_schemas;
};

}  // namespace

std::unique_ptr<BagFile> openMcapBag(const std::filesystem::path& file) {
  return std::make_unique<McapBag>(file);
}

}  // namespace boomwatch
