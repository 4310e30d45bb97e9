#include "sources/bag/sqlite_bag.h"

#include <sqlite3.h>

#include <map>

#include "base/error.h"
#include "sources/bag/decompress.h"

namespace boomwatch {
namespace {

using Database = std::unique_ptr<sqlite3, decltype(&sqlite3_close_v2)>;
using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;

// As sqlite's addresses want it: the signs that end a path there are written as numbers.
std::string addressOf(const std::filesystem::path& file, const char* mode) {
  std::string address = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '%' || c == '?' || c == '#') {
      constexpr const char* digits = "0123456789ABCDEF";
      const auto byte = static_cast<unsigned char>(c);
      address += {'%', digits[byte / 16], digits[byte % 16]};
    } else {
      address += c;
    }
  }
  return address + mode;
}

Database openDatabase(const std::filesystem::path& file, const char* mode) {
  sqlite3* raw = nullptr;
  const int result = sqlite3_open_v2(addressOf(file, mode).c_str(), &raw,
                                     SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  Database database(raw, &sqlite3_close_v2);
  if (result != SQLITE_OK) database.reset();
  if (database) sqlite3_limit(database.get(), SQLITE_LIMIT_LENGTH, static_cast<int>(maxChunk));
  return database;
}

Statement prepare(const Database& database, const char* sql) {
  sqlite3_stmt* raw = nullptr;
  if (database) sqlite3_prepare_v2(database.get(), sql, -1, &raw, nullptr);
  return {raw, &sqlite3_finalize};
}

std::string textAt(const Statement& statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), column));
  return text ? text : "";
}

class SqliteBag : public BagFile {
 public:
  explicit SqliteBag(const std::filesystem::path& file)
      : m_database(openDatabase(file, "?mode=ro")), m_read(nullptr, &sqlite3_finalize) {
    // A folder that cannot be written to has no room for sqlite's locks.
    if (!readTopics()) {
      m_database = openDatabase(file, "?mode=ro&immutable=1");
      if (!readTopics()) {
        throw Error(file.string(), "this sqlite file holds no ROS 2 bag",
                    "Give a bag that 'ros2 bag record' wrote.");
      }
    }
    readMessages();
    m_read = prepare(m_database, "SELECT data FROM messages WHERE id = ?");
  }

  std::optional<std::string> read(const BagMessage& message) override {
    sqlite3_reset(m_read.get());
    sqlite3_bind_int64(m_read.get(), 1, static_cast<sqlite3_int64>(message.place));
    if (sqlite3_step(m_read.get()) != SQLITE_ROW) return std::nullopt;
    const auto* data = static_cast<const char*>(sqlite3_column_blob(m_read.get(), 0));
    const int size = sqlite3_column_bytes(m_read.get(), 0);
    if (!data) return std::nullopt;
    return std::string(data, static_cast<std::size_t>(size));
  }

 private:
  bool readTopics() {
    const auto rows =
        prepare(m_database, "SELECT id, name, type, serialization_format FROM topics");
    if (!rows) return false;
    int result = SQLITE_ROW;
    while ((result = sqlite3_step(rows.get())) == SQLITE_ROW) {
      const bool isCdr = textAt(rows, 3) == "cdr";
      m_index[sqlite3_column_int64(rows.get(), 0)] = m_topics.size();
      m_topics.push_back({textAt(rows, 1), withoutMsg(textAt(rows, 2)),
                          isCdr ? BagEncoding::Cdr : BagEncoding::Other});
    }
    return result == SQLITE_DONE || !m_topics.empty();
  }

  void readMessages() {
    const auto rows =
        prepare(m_database, "SELECT id, topic_id, timestamp FROM messages ORDER BY timestamp, id");
    int result = SQLITE_DONE;
    while (rows && (result = sqlite3_step(rows.get())) == SQLITE_ROW) {
      const auto topic = m_index.find(sqlite3_column_int64(rows.get(), 1));
      const std::int64_t time = sqlite3_column_int64(rows.get(), 2);
      if (topic == m_index.end() || time < 0) continue;
      m_messages.push_back({topic->second, time,
                            static_cast<std::uint64_t>(sqlite3_column_int64(rows.get(), 0)), 0});
    }
    if (result != SQLITE_DONE)
      m_damage = "the file is damaged, and its later messages are left out";
  }

  Database m_database;
  Statement m_read;
  std::map<sqlite3_int64, std::size_t> m_index;  // of a topic by its id
};

}  // namespace

std::unique_ptr<BagFile> openSqliteBag(const std::filesystem::path& file) {
  return std::make_unique<SqliteBag>(file);
}

}  // namespace boomwatch
