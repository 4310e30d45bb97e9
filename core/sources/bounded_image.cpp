#include "sources/bounded_image.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace boomwatch {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<unsigned char>;

// An uncompressed colour picture of the largest size, and its header.
constexpr std::uintmax_t largestFile = static_cast<std::uintmax_t>(largestImage) * 3 + 4096;
// JPEG puts previews and colour profiles before the size.
constexpr std::uintmax_t headerBytes = 1 << 20;

struct WideSize {
  std::int64_t width = 0;
  std::int64_t height = 0;
};

std::int64_t bigEndian(const Bytes& b, std::size_t at, int count) {
  std::int64_t value = 0;
  for (int i = 0; i < count; ++i) value = value << 8 | b[at + static_cast<std::size_t>(i)];
  return value;
}

bool startsWith(const Bytes& b, std::string_view signature) {
  return b.size() >= signature.size() &&
         std::equal(signature.begin(), signature.end(), b.begin(),
                    [](char s, unsigned char c) { return static_cast<unsigned char>(s) == c; });
}

std::optional<WideSize> pngSize(const Bytes& b) {
  if (b.size() < 24) return std::nullopt;
  return WideSize{bigEndian(b, 16, 4), bigEndian(b, 20, 4)};
}

// Walks the segments to the first start-of-frame.
std::optional<WideSize> jpegSize(const Bytes& b) {
  for (std::size_t at = 2; at + 9 < b.size() && b[at] == 0xFF;) {
    const int marker = b[at + 1];
    if (marker == 0xFF) {
      ++at;
      continue;
    }
    const bool frame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (frame) return WideSize{bigEndian(b, at + 7, 2), bigEndian(b, at + 5, 2)};
    at += 2 + static_cast<std::size_t>(bigEndian(b, at + 2, 2));
  }
  return std::nullopt;
}

// libjpeg fills up what a cut file lacks with grey and says that all is well.
bool endsLikeAJpeg(const Bytes& b) {
  constexpr std::array<unsigned char, 2> endOfImage{0xFF, 0xD9};
  // Some cameras add a few bytes.
  const auto tail = b.end() - static_cast<std::ptrdiff_t>(std::min<std::size_t>(b.size(), 1024));
  return std::search(tail, b.end(), endOfImage.begin(), endOfImage.end()) != b.end();
}

std::optional<WideSize> bmpSize(const Bytes& b) {
  if (b.size() < 26) return std::nullopt;
  auto littleEndian = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | b[at + i];
    return static_cast<std::int64_t>(static_cast<std::int32_t>(value));
  };
  // A negative height means rows from top to bottom.
  return WideSize{littleEndian(18), std::abs(littleEndian(22))};
}

std::optional<WideSize> pnmSize(const Bytes& b) {
  std::array<std::int64_t, 2> numbers{};
  std::size_t at = 2;
  for (auto& number : numbers) {
    while (at < b.size() && (std::isspace(b[at]) || b[at] == '#')) {
      if (b[at] == '#') {
        while (at < b.size() && b[at] != '\n') ++at;
      } else {
        ++at;
      }
    }
    const std::size_t begin = at;
    for (; at < b.size() && std::isdigit(b[at]) && at - begin < 12; ++at) {
      number = number * 10 + (b[at] - '0');
    }
    if (at == begin) return std::nullopt;
  }
  return WideSize{numbers[0], numbers[1]};
}

std::optional<WideSize> claimedSize(const Bytes& b) {
  if (startsWith(b, "\x89PNG\r\n\x1A\n")) return pngSize(b);
  if (startsWith(b, "\xFF\xD8")) return jpegSize(b);
  if (startsWith(b, "BM")) return bmpSize(b);
  if (b.size() > 2 && b[0] == 'P' && b[1] >= '1' && b[1] <= '6') return pnmSize(b);
  return std::nullopt;
}

bool acceptable(const WideSize& size) {
  return size.width > 0 && size.height > 0 &&
         static_cast<double>(size.width) * static_cast<double>(size.height) <= largestImage;
}

std::optional<Bytes> readBytes(const fs::path& file, std::uintmax_t most) {
  std::error_code fault;
  if (!fs::is_regular_file(file, fault)) return std::nullopt;
  const auto size = fs::file_size(file, fault);
  if (fault) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  Bytes bytes(static_cast<std::size_t>(std::min(size, most)));
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!stream) return std::nullopt;
  return bytes;
}

}  // namespace

bool hasImageExtension(const fs::path& file) {
  constexpr std::array<std::string_view, 6> known{".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".ppm"};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(known.begin(), known.end(), extension) != known.end();
}

std::optional<cv::Size> imageSize(const fs::path& file) {
  const auto bytes = readBytes(file, headerBytes);
  const auto size = bytes ? claimedSize(*bytes) : std::nullopt;
  if (!size || !acceptable(*size)) return std::nullopt;
  return cv::Size(static_cast<int>(size->width), static_cast<int>(size->height));
}

ImageResult readImage(const fs::path& file) {
  auto fault = [&](const std::string& why) { return ImageResult{{}, file.string() + ": " + why}; };
  const auto bytes = readBytes(file, largestFile);
  if (!bytes) return fault("this file cannot be read");
  const auto size = claimedSize(*bytes);
  if (!size) return fault("this is not a PNG, JPEG, BMP, PGM or PPM picture");
  if (!acceptable(*size)) {
    return fault("a picture of " + std::to_string(size->width) + " x " +
                 std::to_string(size->height) + " pixels is not read");
  }
  if (startsWith(*bytes, "\xFF\xD8") && !endsLikeAJpeg(*bytes)) return fault("the picture is cut");
  try {
    cv::Mat image = cv::imdecode(*bytes, cv::IMREAD_ANYCOLOR | cv::IMREAD_IGNORE_ORIENTATION);
    if (!image.empty()) return {image, ""};
  } catch (const cv::Exception&) {
    // Said below: what OpenCV says here helps no operator.
  }
  return fault("the picture is damaged");
}

}  // namespace boomwatch
