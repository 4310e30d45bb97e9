#include "sources/image_sequence.h"

#include <algorithm>
#include <charconv>

#include "frame/error.h"
#include "sources/bounded_image.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::string_view withoutZeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

// The run of digits at the front, taken off.
std::string_view takeDigits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), isDigit) - text.begin();
  const auto digits = text.substr(0, static_cast<std::size_t>(end));
  text.remove_prefix(digits.size());
  return withoutZeros(digits);
}

}  // namespace

bool naturallyLess(std::string_view a, std::string_view b) {
  const std::string_view wholeA = a, wholeB = b;
  while (!a.empty() && !b.empty()) {
    if (isDigit(a.front()) && isDigit(b.front())) {
      const auto x = takeDigits(a), y = takeDigits(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  // "1" and "01" must not count as one name.
  return a.empty() && b.empty() ? wholeA < wholeB : a.empty();
}

std::vector<fs::path> imagesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code fault;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault)) {
    if (hasImageExtension(at->path())) files.push_back(at->path());
  }
  if (fault) {
    throw Error(folder.string(), "the folder cannot be listed (" + fault.message() + ")",
                "Check the path and its permissions.");
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return naturallyLess(a.filename().string(), b.filename().string());
  });
  return files;
}

std::optional<std::string> numberIn(const fs::path& file) {
  const std::string stem = file.stem().string();
  const auto last = std::find_if(stem.rbegin(), stem.rend(), isDigit);
  if (last == stem.rend()) return std::nullopt;
  const auto first = std::find_if_not(last, stem.rend(), isDigit);
  return std::string(withoutZeros(std::string(first.base(), last.base())));
}

std::optional<double> stampIn(const fs::path& file) {
  // Nanoseconds since 1970 take 19 digits from 2001 to 2286.
  constexpr std::size_t digits = 19;
  const std::string stem = file.stem().string();
  std::int64_t nanoseconds = 0;
  const auto [end, fault] = std::from_chars(stem.data(), stem.data() + stem.size(), nanoseconds);
  if (stem.size() != digits || fault != std::errc() || end != stem.data() + digits) {
    return std::nullopt;
  }
  return static_cast<double>(nanoseconds) * 1e-9;
}

std::optional<cv::Size> ImageSequence::size() const {
  return m_files.empty() ? std::nullopt : imageSize(m_files.front());
}

StreamImage ImageSequence::read(std::size_t index) {
  auto [image, fault] = readImage(m_files.at(index));
  return {image, fault, false};
}

}  // namespace boomwatch
