#include "lab/evaluation/ground_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "files/file_bytes.h"
#include "files/line_reader.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;
using Numbers = std::array<double, 4>;

constexpr std::size_t maxFile = std::size_t{16} << 20;
constexpr double maxNumber = 1e6;

enum class Layout { Sizes, Corners };

bool isHidden(const Numbers& line) {
  return std::isnan(line[0]) || (line[2] == 0.0 && line[3] == 0.0);
}

bool isCredible(const Numbers& numbers) {
  const auto nan = std::ranges::count_if(numbers, [](double n) { return std::isnan(n); });
  const bool bounded =
      std::ranges::all_of(numbers, [](double n) { return std::abs(n) <= maxNumber; });
  return nan == 4 || (nan == 0 && bounded);
}

std::optional<Numbers> numbersOf(std::string line) {
  std::ranges::replace(line, ',', ' ');
  const auto parts = words(line);
  Numbers numbers{};
  if (parts.size() != numbers.size()) return std::nullopt;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = toNumber<double>(parts[i]);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return isCredible(numbers) ? std::optional(numbers) : std::nullopt;
}

[[noreturn]] void refuseLine(const fs::path& file, std::size_t line, const std::string& what) {
  throw Error(file.string() + ", line " + std::to_string(line), what,
              "A line is four numbers, parted by commas, or four times NaN.");
}

std::vector<Numbers> linesOf(const fs::path& file) {
  std::string text = readFileBytes(file, maxFile);
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  std::vector<Numbers> lines;
  LineReader reader(text);
  while (const auto line = reader.next()) {
    const auto numbers = numbersOf(std::string(*line));
    if (!numbers) refuseLine(file, reader.lineNumber(), "these are not four numbers");
    lines.push_back(*numbers);
  }
  if (lines.empty()) throw Error(file.string(), "it is empty", "Write one line a frame.");
  return lines;
}

bool canBeCorners(const Numbers& line) {
  return isHidden(line) || (line[2] >= line[0] && line[3] >= line[1]);
}

/// Data sets let a box reach out of the picture a little.
bool canBeSizes(const Numbers& line, cv::Size image) {
  return isHidden(line) || (line[0] + line[2] <= 1.1 * image.width + 1.0 &&
                            line[1] + line[3] <= 1.1 * image.height + 1.0);
}

Layout layoutOf(const fs::path& file, const std::vector<Numbers>& lines, cv::Size image) {
  if (file.filename() == "groundtruth_rect.txt") return Layout::Sizes;
  if (fs::exists(file.parent_path() / "init.txt")) return Layout::Corners;
  const bool corners = std::ranges::all_of(lines, canBeCorners);
  const bool sizes =
      std::ranges::all_of(lines, [&](const Numbers& line) { return canBeSizes(line, image); });
  if (corners != sizes) return corners ? Layout::Corners : Layout::Sizes;
  throw Error(file.string(),
              "it cannot be told whether its lines are x, y, width, height or x1, "
              "y1, x2, y2",
              "Name it groundtruth_rect.txt if it is the first; put init.txt beside it if it is "
              "the second.");
}

}  // namespace

std::optional<fs::path> groundTruthFile(const fs::path& folder) {
  for (const char* name : {"groundtruth_rect.txt", "gt.txt"}) {
    std::error_code fault;
    if (fs::is_regular_file(folder / name, fault)) return folder / name;
  }
  return std::nullopt;
}

GroundTruth readGroundTruth(const fs::path& folder, cv::Size image) {
  const auto file = groundTruthFile(folder);
  if (!file) {
    throw Error(folder.string(), "there is no ground truth",
                "Put groundtruth_rect.txt or gt.txt beside the pictures.");
  }
  const auto lines = linesOf(*file);
  const Layout layout = layoutOf(*file, lines, image);
  GroundTruth truth;
  for (const Numbers& line : lines) {
    if (isHidden(line)) {
      truth.emplace_back();
      continue;
    }
    cv::Rect2d box(line[0] - 1.0, line[1] - 1.0, line[2], line[3]);
    if (layout == Layout::Corners) {
      // The last column and row still belong to the box.
      box.width = line[2] - line[0] + 1.0;
      box.height = line[3] - line[1] + 1.0;
    }
    if (!(box.width > 0.0 && box.height > 0.0)) {
      refuseLine(*file, truth.size() + 1, "its box has no size");
    }
    truth.emplace_back(box);
  }
  return truth;
}

}  // namespace boomwatch
