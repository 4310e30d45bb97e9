#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace boomwatch {

/// `given` made absolute, when it is not there yet or is empty. Throws Error that names --output
/// otherwise, or when it is empty text.
std::filesystem::path emptyFolder(const std::filesystem::path& given);

/// Writes a whole file. Throws std::runtime_error that names it when that fails.
void writeText(const std::filesystem::path& file, const std::string& text);
void writeBytes(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// A folder that is being filled: FOLDER.partial, which gets its name when it is complete, and is
/// removed unless it was finished. So nothing half-written looks whole.
class PartialFolder {
 public:
  /// Makes it. Throws Error when it is there already or cannot be made.
  explicit PartialFolder(const std::filesystem::path& folder);
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;
  ~PartialFolder();

  const std::filesystem::path& path() const { return m_path; }
  /// A folder in it, made if it is missing. Throws std::runtime_error when that fails.
  std::filesystem::path sub(const char* name) const;
  /// Gives it its name. Throws std::runtime_error when that fails.
  void finish();

 private:
  std::filesystem::path m_final, m_path;
  bool m_finished = false;
};

}  // namespace boomwatch
