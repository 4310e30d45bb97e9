#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <list>
#include <map>
#include <memory>

#include "sources/bag/bag_file.h"

namespace boomwatch {

/// A bag whose messages lie in compressed chunks. The formats tell how a chunk is read; this keeps
/// the chunks used last, because left and right of a pair lie in the same one.
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

  /// Sorts the messages by time, and says what is missing, once the file was walked through.
  void finish(std::uint64_t damagedChunks, bool isCut);

 private:
  std::ifstream m_stream;
  std::uint64_t m_size = 0;
  std::list<std::pair<std::uint64_t, std::optional<std::string>>> m_recent;
};

}  // namespace boomwatch
