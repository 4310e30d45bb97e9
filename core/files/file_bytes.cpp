#include "files/file_bytes.h"

#include <fstream>
#include <random>

#include "base/error.h"

namespace boomwatch {
namespace {

/// A name beside `file` that nothing has.
std::filesystem::path temporaryBeside(const std::filesystem::path& file) {
  std::random_device random;
  std::filesystem::path temporary = file;
  temporary += '.';
  temporary += std::to_string(random());
  temporary += ".part";
  return temporary;
}

}  // namespace

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

bool replaceFile(const std::filesystem::path& file, const std::string& bytes) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const fs::path target = fs::is_symlink(file, fault) ? fs::weakly_canonical(file, fault) : file;
  const fs::path temporary = temporaryBeside(target);
  std::ofstream out(temporary, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  fault.clear();
  if (out) fs::rename(temporary, target, fault);
  if (out && !fault) return true;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return false;
}

}  // namespace boomwatch
