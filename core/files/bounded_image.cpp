#include "files/bounded_image.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <string_view>

#include "base/error.h"
#include "files/file_bytes.h"
#include "files/line_reader.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

// An uncompressed colour picture of the largest size, and its header.
constexpr std::size_t maxFile = static_cast<std::size_t>(maxImage) * 3 + 4096;
constexpr std::string_view jpegSignature = "\xFF\xD8";

struct WideSize {
  std::int64_t width = 0;
  std::int64_t height = 0;
};

std::uint8_t byteAt(std::string_view b, std::size_t at) { return static_cast<std::uint8_t>(b[at]); }

std::int64_t bigEndian(std::string_view b, std::size_t at, std::size_t count) {
  std::int64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | byteAt(b, at + i);
  return value;
}

std::optional<WideSize> pngSize(std::string_view b) {
  if (b.size() < 24) return std::nullopt;
  return WideSize{bigEndian(b, 16, 4), bigEndian(b, 20, 4)};
}

// Walks the segments to the first start-of-frame.
std::optional<WideSize> jpegSize(std::string_view b) {
  for (std::size_t at = 2; at + 9 < b.size() && byteAt(b, at) == 0xFF;) {
    const int marker = byteAt(b, at + 1);
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
bool endsLikeAJpeg(std::string_view b) {
  constexpr std::size_t tail = 1024;  // some cameras add a few bytes
  return b.substr(b.size() - std::min(b.size(), tail)).find("\xFF\xD9") != std::string_view::npos;
}

std::optional<WideSize> bmpSize(std::string_view b) {
  if (b.size() < 26) return std::nullopt;
  auto littleEndian = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | byteAt(b, at + i);
    return static_cast<std::int64_t>(static_cast<std::int32_t>(value));
  };
  // A negative height means rows from top to bottom.
  return WideSize{littleEndian(18), std::abs(littleEndian(22))};
}

std::optional<WideSize> pnmSize(std::string_view b) {
  const auto isBlank = [&](std::size_t k) { return std::isspace(byteAt(b, k)) != 0; };
  std::array<std::int64_t, 2> numbers{};
  std::size_t at = 2;
  for (auto& number : numbers) {
    while (at < b.size() && (isBlank(at) || b[at] == '#')) {
      if (b[at] == '#') {
        while (at < b.size() && b[at] != '\n') ++at;
      } else {
        ++at;
      }
    }
    const std::size_t begin = at;
    for (; at < b.size() && isDigit(b[at]) && at - begin < 12; ++at) {
      number = number * 10 + (b[at] - '0');
    }
    if (at == begin) return std::nullopt;
  }
  return WideSize{numbers[0], numbers[1]};
}

std::optional<WideSize> claimedSize(std::string_view b) {
  if (b.starts_with("\x89PNG\r\n\x1A\n")) return pngSize(b);
  if (b.starts_with(jpegSignature)) return jpegSize(b);
  if (b.starts_with("BM")) return bmpSize(b);
  if (b.size() > 2 && b[0] == 'P' && b[1] >= '1' && b[1] <= '6') return pnmSize(b);
  return std::nullopt;
}

bool acceptable(const WideSize& size) {
  return size.width > 0 && size.height > 0 &&
         static_cast<double>(size.width) * static_cast<double>(size.height) <= maxImage;
}

cv::Mat decode(std::string_view bytes, PixelDepth depth) {
  const int flags = depth == PixelDepth::AsStored
                        ? cv::IMREAD_UNCHANGED
                        : cv::IMREAD_ANYCOLOR | cv::IMREAD_IGNORE_ORIENTATION;
  const cv::Mat view(1, static_cast<int>(bytes.size()), CV_8UC1,
                     const_cast<char*>(bytes.data()));  // imdecode only reads
  try {
    return cv::imdecode(view, flags);
  } catch (const cv::Exception&) {
    return {};  // what OpenCV says here helps no operator
  }
}

}  // namespace

bool hasImageExtension(const fs::path& file) {
  constexpr std::array<std::string_view, 6> known{".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".ppm"};
  return std::ranges::find(known, lowerExtension(file)) != known.end();
}

std::optional<cv::Size> imageSize(const fs::path& file) {
  try {
    const auto size = claimedSize(readFileBytes(file, maxFile));
    if (!size || !acceptable(*size)) return std::nullopt;
    return cv::Size(static_cast<int>(size->width), static_cast<int>(size->height));
  } catch (const Error&) {
    return std::nullopt;
  }
}

cv::Mat readImage(const fs::path& file, PixelDepth depth) {
  const std::string where = file.string();
  const std::string bytes = readFileBytes(file, maxFile);
  const auto size = claimedSize(bytes);
  if (!size) {
    throw Error(where, "this is not a PNG, JPEG, BMP, PGM or PPM picture", "Convert it to one.");
  }
  if (!acceptable(*size)) {
    throw Error(where,
                "a picture of " + std::to_string(size->width) + " x " +
                    std::to_string(size->height) + " pixels is not read",
                "Scale it down.");
  }
  if (bytes.starts_with(jpegSignature) && !endsLikeAJpeg(bytes)) {
    throw Error(where, "the picture is cut", "Copy it again.");
  }
  cv::Mat image = decode(bytes, depth);
  if (image.empty()) throw Error(where, "the picture is damaged", "Copy it again.");
  return image;
}

cv::Mat decodeImage(std::string_view bytes, PixelDepth depth) {
  const auto size = claimedSize(bytes);
  const bool isCut = bytes.starts_with(jpegSignature) && !endsLikeAJpeg(bytes);
  if (!size || !acceptable(*size) || isCut || bytes.size() > maxFile) return {};
  return decode(bytes, depth);
}

}  // namespace boomwatch
