#include "sources/bag/ros1_bag.h"

#include <map>
#include <string_view>

#include "base/error.h"
#include "sources/bag/byte_cursor.h"
#include "sources/bag/chunked_bag.h"
#include "sources/bag/decompress.h"

namespace boomwatch {
namespace {

// Kinds of records, by the field "op" of their header.
enum Op : std::uint8_t { Message = 2, Index = 4, Chunk = 5, Connection = 7 };

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
  explicit Ros1Bag(const std::filesystem::path& file) : ChunkedBag(file) { finish(walkFile()); }

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

  // True when the file is cut.
  bool walkFile() {
    constexpr std::uint64_t signature = 13;
    for (std::uint64_t place = signature; place < fileSize();) {
      const auto record = recordAt(place);
      if (!record || record->data + record->size > fileSize()) return true;
      const auto op = numberIn<std::uint8_t>(record->header, "op");
      if (op == Index) {
        takeIndex(*record);
      } else if (op == Chunk) {
        beginChunk(place);
      } else {
        endChunk();
      }
      if (op == Connection) takeConnection(record->header, bytesAt(record->data, record->size));
      // A bag that was not closed ends with messages of a chunk that has no size yet.
      if (op == Message) takeMessage(record->header, 0, place);
      place = record->data + record->size;
    }
    return false;
  }

  void takeConnection(const Fields& header, const std::optional<std::string>& data) {
    if (!data) return;
    BagTopic& topic = m_topics[topicOf(numberIn<std::uint32_t>(header, "conn"))];
    topic = {textIn(header, "topic"), textIn(fieldsOf(*data), "type"), BagEncoding::Ros1};
  }

  void takeMessage(const Fields& header, std::uint64_t chunk, std::uint64_t offset) {
    const std::string bytes = textIn(header, "time");
    ByteCursor time(bytes);
    const std::size_t topic = topicOf(numberIn<std::uint32_t>(header, "conn"));
    addMessage({topic, timeFrom(time), chunk, offset});
  }

  // The times and offsets of one connection's messages in the chunk before it.
  void takeIndex(const Record& record) {
    const auto data = bytesAt(record.data, record.size);
    const auto chunk = data ? indexedChunk() : std::nullopt;
    if (!chunk) return;
    const std::size_t topic = topicOf(numberIn<std::uint32_t>(record.header, "conn"));
    for (ByteCursor cursor(*data); !cursor.atEnd();) {
      const std::int64_t time = timeFrom(cursor);
      const auto offset = cursor.number<std::uint32_t>();
      if (!cursor.failed()) addMessage({topic, time, *chunk, offset});
    }
  }

  void walkChunk(std::uint64_t place, bool withMessages) override {
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
    if (!packed) return std::nullopt;
    return decompress(textIn(record->header, "compression"), *packed,
                      numberIn<std::uint32_t>(record->header, "size"));
  }
};

}  // namespace

std::unique_ptr<BagFile> openRos1Bag(const std::filesystem::path& file) {
  return std::make_unique<Ros1Bag>(file);
}

}  // namespace boomwatch
