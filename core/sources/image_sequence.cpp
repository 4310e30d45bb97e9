#include "sources/image_sequence.h"

#include <algorithm>

#include "base/error.h"
#include "files/bounded_image.h"
#include "files/line_reader.h"
#include "sources/file_sequence.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

std::string_view withoutZeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

}  // namespace

std::vector<fs::path> imagesIn(const fs::path& folder) {
  return listFiles(folder, hasImageExtension);
}

std::optional<std::string> numberIn(const fs::path& file) {
  const std::string stem = file.stem().string();
  const auto last = std::find_if(stem.rbegin(), stem.rend(), isDigit);
  if (last == stem.rend()) return std::nullopt;
  const auto first = std::find_if_not(last, stem.rend(), isDigit);
  return std::string(withoutZeros(std::string(first.base(), last.base())));
}

std::optional<cv::Size> ImageSequence::size() const {
  return m_files.empty() ? std::nullopt : imageSize(m_files.front());
}

StreamImage ImageSequence::read(std::size_t index) {
  try {
    return {readImage(m_files.at(index)), "", false};
  } catch (const Error& error) {
    return {{}, error.what(), false};
  }
}

}  // namespace boomwatch
