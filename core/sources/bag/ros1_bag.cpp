#include "sources/bag/ros1_bag.h"

#include <map>
#include <set>
#include <string_view>

#include "base/error.h"
#include "sources/bag/byte_cursor.h"
#include "sources/bag/chunked_bag.h"
#include "sources/bag/decompress.h"

namespace boomwatch {
namespace {

// Kinds of records, by the field "op" of their header.
enum Op : std::uint8_t {
  Message = 2,
  Header = 3,
  Index = 4,
  Chunk = 5,
  ChunkInfo = 6,
  Connection = 7
};

using Fields = std::map<std::string, std::string, std::less<>>;

// Each field is its length, 32 bits, and name=value.
Fields fieldsOf(std::string_view bytes) {
  Fields fields;
  for (ByteCursor cursor(bytes); !cursor.atEnd();) {
    const std::string_view field = cursor.counted();
    const auto equals = field.find('=');
    if (equals == std::string_view::npos) break;
    fields.emplace(field.substr(0, equals), field.substr(equals + 1));
  }
  return fields;
}

template <class T>
T numberIn(const Fields& fields, std::string_view key) {
  const auto found = fields.find(key);
  return found == fields.end() ? T{} : ByteCursor(found->second).number<T>();
}

std::string textIn(const Fields& fields, std::string_view key) {
  const auto found = fields.find(key);
  return found == fields.end() ? std::string() : found->second;
}

std::int64_t timeFrom(ByteCursor& cursor) {
  const auto seconds = cursor.number<std::uint32_t>();
  const auto nanoseconds = cursor.number<std::uint32_t>();
  return std::int64_t(seconds) * 1'000'000'000 + nanoseconds;
}

class Ros1Bag : public ChunkedBag {
 public:
  explicit Ros1Bag(const std::filesystem::path& file) : ChunkedBag(file) {
    walkFile();
    // A bag that was not closed has its connections in the chunks alone.
    if (!m_unknown.empty()) {
      for (const std::uint64_t chunk : m_chunks) walkChunk(chunk, false);
    }
    std::erase_if(m_messages,
                  [this](const BagMessage& m) { return m_topics[m.topic].name.empty(); });
    finish(m_damaged.size(), m_isCut);
  }

  std::optional<std::string> read(const BagMessage& message) override {
    if (message.place == 0) {  // outside all chunks
      const auto record = recordAt(message.offset);
      return record ? bytesAt(record->data, record->size) : std::nullopt;
    }
    const std::string* chunk = chunkAt(message.place);
    if (!chunk || message.offset > chunk->size()) return std::nullopt;
    ByteCursor cursor(std::string_view(*chunk).substr(message.offset));
    cursor.counted();
    const std::string_view data = cursor.counted();
    if (cursor.failed()) return std::nullopt;
    return std::string(data);
  }

 private:
  struct Record {
    Fields header;
    std::uint64_t data = 0;  // place of its bytes
    std::uint32_t size = 0;
  };

  // Absent at the end, and where the file is cut.
  std::optional<Record> recordAt(std::uint64_t place) {
    const auto length = bytesAt(place, 4);
    if (!length) return std::nullopt;
    const auto headerSize = ByteCursor(*length).number<std::uint32_t>();
    const auto header = bytesAt(place + 4, std::uint64_t(headerSize) + 4);
    if (!header) return std::nullopt;
    ByteCursor cursor(*header);
    Record record{fieldsOf(cursor.take(headerSize)), place + headerSize + 8, 0};
    record.size = cursor.number<std::uint32_t>();
    return record;
  }

  void walkFile() {
    constexpr std::uint64_t signature = 13;
    std::uint64_t place = signature;
    bool indexed = true;
    const auto walkLast = [&] {
      if (!indexed) walkChunk(m_chunks.back(), true);
    };
    while (place < fileSize()) {
      const auto record = recordAt(place);
      if (!record || record->data + record->size > fileSize()) {
        m_isCut = true;
        break;
      }
      const auto op = numberIn<std::uint8_t>(record->header, "op");
      if (op == Index) {
        indexed = takeIndex(*record) || indexed;
      } else {
        walkLast();
        indexed = true;
      }
      if (op == Chunk) {
        m_chunks.push_back(place);
        indexed = false;
      }
      if (op == Connection) takeConnection(record->header, bytesAt(record->data, record->size));
      // A bag that was not closed ends with messages of a chunk that has no size yet.
      if (op == Message) takeMessage(record->header, 0, place);
      place = record->data + record->size;
    }
    walkLast();
  }

  std::size_t topicOf(std::uint32_t connection) {
    const auto [found, isNew] = m_connections.try_emplace(connection, m_topics.size());
    if (isNew) {
      m_topics.push_back({{}, {}, BagEncoding::Ros1});
      m_unknown.insert(found->second);
    }
    return found->second;
  }

  void takeConnection(const Fields& header, const std::optional<std::string>& data) {
    if (!data) return;
    BagTopic& topic = m_topics[topicOf(numberIn<std::uint32_t>(header, "conn"))];
    topic.name = textIn(header, "topic");
    topic.type = textIn(fieldsOf(*data), "type");
    if (!topic.name.empty()) m_unknown.erase(static_cast<std::size_t>(&topic - m_topics.data()));
  }

  void takeMessage(const Fields& header, std::uint64_t chunk, std::uint64_t offset) {
    const std::string bytes = textIn(header, "time");
    ByteCursor time(bytes);
    const std::size_t topic = topicOf(numberIn<std::uint32_t>(header, "conn"));
    m_messages.push_back({topic, timeFrom(time), chunk, offset});
  }

  // The times and offsets of one connection's messages in the chunk before it.
  bool takeIndex(const Record& record) {
    const auto data = bytesAt(record.data, record.size);
    if (!data || m_chunks.empty()) return false;
    const std::size_t topic = topicOf(numberIn<std::uint32_t>(record.header, "conn"));
    for (ByteCursor cursor(*data); !cursor.atEnd();) {
      const std::int64_t time = timeFrom(cursor);
      const auto offset = cursor.number<std::uint32_t>();
      if (!cursor.failed()) m_messages.push_back({topic, time, m_chunks.back(), offset});
    }
    return true;
  }

  // What a chunk tells of itself: its connections, and its messages where no index did.
  void walkChunk(std::uint64_t place, bool withMessages) {
    const std::string* chunk = chunkAt(place);
    if (!chunk) return;
    for (ByteCursor cursor(*chunk); !cursor.atEnd();) {
      const std::uint64_t offset = cursor.position();
      const Fields header = fieldsOf(cursor.counted());
      const std::string_view data = cursor.counted();
      if (cursor.failed()) break;
      const auto op = numberIn<std::uint8_t>(header, "op");
      if (op == Connection) takeConnection(header, std::string(data));
      if (op == Message && withMessages) takeMessage(header, place, offset);
    }
  }

  std::optional<std::string> readChunk(std::uint64_t place) override {
    const auto record = recordAt(place);
    const auto packed = record ? bytesAt(record->data, record->size) : std::nullopt;
    auto chunk = packed ? decompress(textIn(record->header, "compression"), *packed,
                                     numberIn<std::uint32_t>(record->header, "size"))
                        : std::nullopt;
    if (!chunk) m_damaged.insert(place);
    return chunk;
  }

  std::map<std::uint32_t, std::size_t> m_connections;  // to topics
  std::set<std::size_t> m_unknown;                     // topics of which no name was found so far
  std::vector<std::uint64_t> m_chunks;
  std::set<std::uint64_t> m_damaged;
  bool m_isCut = false;
};

}  // namespace

std::unique_ptr<BagFile> openRos1Bag(const std::filesystem::path& file) {
  return std::make_unique<Ros1Bag>(file);
}

}  // namespace boomwatch
