#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sources/image_stream.h"

namespace boomwatch {

/// The pictures in a folder, in natural order. Throws Error when it cannot be listed.
std::vector<std::filesystem::path> imagesIn(const std::filesystem::path& folder);

/// The last number in a file's name, as digits without leading zeros; absent if there is none.
std::optional<std::string> numberIn(const std::filesystem::path& file);

/// Picture files as one camera's recording.
class ImageSequence : public ImageStream {
 public:
  explicit ImageSequence(std::vector<std::filesystem::path> files) : m_files(std::move(files)) {}

  std::size_t count() const override { return m_files.size(); }
  std::optional<double> rate() const override { return std::nullopt; }
  std::optional<cv::Size> size() const override;
  StreamImage read(std::size_t index) override;

 private:
  std::vector<std::filesystem::path> m_files;
};

}  // namespace boomwatch
