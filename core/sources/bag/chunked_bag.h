#pragma once

#include <cstdint>
#include <fstream>
#include <list>
#include <map>
#include <set>
#include <utility>

#include "sources/bag/bag_file.h"

namespace boomwatch {

/// A bag whose messages lie in compressed chunks, as ROS 1's and MCAP's do. The formats read the
/// records; this keeps what both need. The chunks used last stay unpacked, because left and right
/// of a pair lie in the same one.
class ChunkedBag : public BagFile {
 protected:
  /// Throws Error when it cannot be opened.
  explicit ChunkedBag(const std::filesystem::path& file);

  std::uint64_t fileSize() const { return m_size; }
  /// `count` bytes at `place`; absent beyond the end or above maxChunk.
  std::optional<std::string> bytesAt(std::uint64_t place, std::uint64_t count);

  /// The unpacked chunk at `place`; null when it is damaged. Valid until the next call.
  const std::string* chunkAt(std::uint64_t place);
  virtual std::optional<std::string> readChunk(std::uint64_t place) = 0;
  /// Takes what a chunk tells of its topics, and its messages if `withMessages`.
  virtual void walkChunk(std::uint64_t place, bool withMessages) = 0;

  /// To be called at each chunk of the file.
  void beginChunk(std::uint64_t place);
  /// To be called at each index; gives the chunk that it belongs to, absent where there is none.
  std::optional<std::uint64_t> indexedChunk();
  /// To be called at every other record and at the end: walks through a chunk without an index.
  void endChunk();

  /// Index into m_topics of what the file numbers `id`. Its name may come later.
  std::size_t topicOf(std::uint32_t id);
  /// Leaves out a message whose time no clock shows.
  void addMessage(const BagMessage& message);

  /// Once the file was walked through: finds the names that are in chunks alone, sorts the messages
  /// by time, and says what is missing.
  void finish(bool isCut);

 private:
  std::ifstream m_stream;
  std::uint64_t m_size = 0;
  std::list<std::pair<std::uint64_t, std::optional<std::string>>> m_recent;
  std::vector<std::uint64_t> m_chunks;
  bool m_isIndexed = true;  ///< the last chunk
  std::map<std::uint32_t, std::size_t> m_topicOf;
  std::set<std::uint64_t> m_damaged;
};

}  // namespace boomwatch
