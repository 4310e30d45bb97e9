#include "report/partial_folder.h"

#include <fstream>
#include <stdexcept>

#include "base/error.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failed(const fs::path& file) {
  throw std::runtime_error(file.string() +
                           ": cannot be written. Free some space, or name another folder with "
                           "--output; what was written has been removed.");
}

void write(const fs::path& file, const char* data, std::size_t size) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(data, static_cast<std::streamsize>(size));
  stream.close();
  if (!stream) failed(file);
}

}  // namespace

fs::path emptyFolder(const fs::path& given) {
  if (given.empty()) throw Error("--output", "no folder is named", "Name one: --output FOLDER.");
  std::error_code fault;
  const fs::path whole = fs::absolute(given).lexically_normal();
  fs::path folder = whole.has_filename() ? whole : whole.parent_path();
  if (fs::exists(folder, fault) &&
      !(fs::is_directory(folder, fault) && fs::is_empty(folder, fault))) {
    throw Error(folder.string(), "it is not an empty folder",
                "Name one that is empty or not there yet with --output.");
  }
  return folder;
}

void writeText(const fs::path& file, const std::string& text) {
  write(file, text.data(), text.size());
}

void writeBytes(const fs::path& file, std::span<const std::uint8_t> bytes) {
  write(file, reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

PartialFolder::PartialFolder(const fs::path& folder) : m_final(folder), m_path(folder) {
  m_path += ".partial";
  std::error_code fault;
  if (fs::exists(m_path, fault)) {
    throw Error(m_path.string(), "it is there already, from a run that was cut short",
                "Remove it, or name another folder with --output.");
  }
  if (!fs::create_directories(m_path, fault)) {
    throw Error(m_path.string(), "it cannot be made: " + fault.message(),
                "Name a folder that can be written with --output.");
  }
}

PartialFolder::~PartialFolder() {
  std::error_code fault;
  if (!m_finished) fs::remove_all(m_path, fault);
}

fs::path PartialFolder::sub(const char* name) const {
  std::error_code fault;
  fs::create_directories(m_path / name, fault);
  if (fault) failed(m_path / name);
  return m_path / name;
}

void PartialFolder::finish() {
  std::error_code fault;
  fs::remove(m_final, fault);  // empty, or not there
  fs::rename(m_path, m_final, fault);
  if (fault) failed(m_final);
  m_finished = true;
}

}  // namespace boomwatch
