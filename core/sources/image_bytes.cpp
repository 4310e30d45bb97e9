#include "sources/image_bytes.h"

#include <algorithm>
#include <cctype>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <string_view>

#include "frame/error.h"
#include "sources/file_bytes.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxFile = std::size_t{1} << 28;
constexpr std::uint64_t maxPixels = 100'000'000;

std::uint32_t bigEndian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < count; ++k) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  }
  return value;
}

std::optional<std::uint64_t> pixelsOfPng(std::string_view bytes) {
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.size() < 24) return std::nullopt;
  return std::uint64_t{bigEndian(bytes, 16, 4)} * bigEndian(bytes, 20, 4);
}

std::optional<std::uint64_t> pixelsOfJpeg(std::string_view bytes) {
  if (!bytes.starts_with("\xff\xd8")) return std::nullopt;
  for (std::size_t at = 2; at + 9 <= bytes.size();) {
    if (bytes[at] != '\xff') return std::nullopt;
    const auto marker = static_cast<unsigned char>(bytes[at + 1]);
    const bool isFill = marker == 0xff;
    if (isFill) {
      ++at;
      continue;
    }
    // Start of frame, of whichever kind; C4, C8 and CC are other things.
    if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) {
      return std::uint64_t{bigEndian(bytes, at + 5, 2)} * bigEndian(bytes, at + 7, 2);
    }
    at += 2 + bigEndian(bytes, at + 2, 2);
  }
  return std::nullopt;
}

}  // namespace

bool isImageFile(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

cv::Mat readImageFile(const std::filesystem::path& file) {
  const std::string where = file.string();
  const std::string bytes = readFileBytes(file, maxFile);
  auto pixels = pixelsOfPng(bytes);
  if (!pixels) pixels = pixelsOfJpeg(bytes);
  if (!pixels) throw Error(where, "neither a PNG nor a JPEG", "Convert or copy it again.");
  if (*pixels > maxPixels) {
    throw Error(where, "it claims more than " + std::to_string(maxPixels) + " pixels",
                "Scale it down.");
  }
  cv::Mat image;
  try {
    const cv::Mat view(1, static_cast<int>(bytes.size()), CV_8UC1,
                       const_cast<char*>(bytes.data()));  // imdecode only reads
    image = cv::imdecode(view, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) throw Error(where, "the image is damaged", "Copy it again.");
  return image;
}

}  // namespace boomwatch
