#include "files/file_bytes.h"

#include <fstream>

#include "frame/error.h"

namespace boomwatch {

std::string readFileBytes(const std::filesystem::path& file, std::size_t limit) {
  namespace fs = std::filesystem;
  const std::string where = file.string();
  std::error_code fault;
  const fs::file_status status = fs::status(file, fault);
  if (!fs::exists(status)) throw Error(where, "there is no such file", "Check the path.");
  if (!fs::is_regular_file(status)) {
    throw Error(where, "this is not an ordinary file", "Give the path of a file.");
  }
  const std::uintmax_t size = fs::file_size(file, fault);
  if (fault) throw Error(where, "cannot be read: " + fault.message(), "Check its permissions.");
  if (size == 0) throw Error(where, "the file is empty", "Copy or write it again.");
  if (size > limit) {
    throw Error(where, "the file is larger than " + std::to_string(limit) + " bytes",
                "Split or shrink it.");
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw Error(where, "cannot be read", "Check its permissions and the disk.");
  return bytes;
}

}  // namespace boomwatch
