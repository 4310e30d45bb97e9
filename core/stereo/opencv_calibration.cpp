#include <algorithm>
#include <opencv2/core/persistence.hpp>
#include <optional>
#include <vector>

#include "frame/error.h"
#include "stereo/calibration_formats.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

struct Storage {
  fs::path file;
  cv::FileStorage data;

  cv::FileNode operator[](const char* key) const { return data[key]; }
  bool has(const char* key) const { return !data[key].empty(); }
};

// cv::FileStorage recurses once a level and keeps kilobytes on the stack each time, so that a file
// of nothing but brackets would end the program. A calibration is three levels deep.
bool nestsTooDeep(const std::string& text) {
  constexpr int deepest = 16;
  int brackets = 0, dashes = 0, tags = 0, indent = 0;
  bool atStart = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      atStart = true;
      dashes = indent = 0;
    } else if (c == '[' || c == '{') {
      ++brackets;
    } else if (c == ']' || c == '}') {
      --brackets;
    } else if (c == '-' && i + 1 < text.size() && text[i + 1] == ' ') {
      ++dashes;
    } else if (c == '<' && i + 1 < text.size()) {
      tags += text[i + 1] == '/' ? -1 : (text[i + 1] == '!' || text[i + 1] == '?') ? 0 : 1;
    } else if (c == ' ' && atStart) {
      ++indent;
    }
    atStart = atStart && (c == ' ' || c == '\n');
    if (std::max({brackets, dashes, tags}) > deepest || indent > 256) return true;
  }
  return false;
}

Storage open(const fs::path& file, const std::string& text) {
  const std::string remedy = "Give a file as OpenCV's stereo calibration writes it.";
  if (nestsTooDeep(text)) throw Error(file.string(), "this nests too deep", remedy);
  try {
    Storage storage{file, {text, cv::FileStorage::READ | cv::FileStorage::MEMORY}};
    if (storage.data.isOpened() && storage.data.root().isMap()) return storage;
  } catch (const cv::Exception& fault) {
    throw Error(file.string(), "this is not YAML or XML that OpenCV can read (" + fault.err + ")",
                remedy);
  }
  throw Error(file.string(), "this holds no keys and values", remedy);
}

[[noreturn]] void wrongShape(const Storage& storage, const char* key, const std::string& wanted) {
  throw Error(storage.file.string(), std::string(key) + " must hold " + wanted,
              "Correct it, or calibrate anew.");
}

// The numbers of an OpenCV matrix or a plain list. The node is taken apart by hand because OpenCV
// allocates whatever rows and columns it is told before it counts the data.
std::vector<double> readNumbers(const Storage& storage, const char* key) {
  constexpr std::size_t most = 64;
  const cv::FileNode node = storage[key];
  if (node.empty()) {
    throw Error(storage.file.string(), std::string("the key ") + key + " is missing",
                "A stereo calibration has M1, D1, M2, D2, R and T.");
  }
  const cv::FileNode data = node.isMap() ? node["data"] : node;
  if (!data.isSeq() || data.size() > most) {
    wrongShape(storage, key, "a matrix of at most 64 numbers, written as text");
  }
  std::vector<double> numbers;
  for (const auto& element : data) {
    if (!element.isInt() && !element.isReal()) wrongShape(storage, key, "numbers only");
    numbers.push_back(static_cast<double>(element));
  }
  if (node.isMap()) {
    const cv::FileNode rows = node["rows"], columns = node["cols"];
    const bool fits = rows.isInt() && columns.isInt() && int(rows) >= 0 && int(columns) >= 0 &&
                      std::size_t(int(rows)) * std::size_t(int(columns)) == numbers.size();
    if (!fits) wrongShape(storage, key, "as many numbers as rows x cols says");
  }
  return numbers;
}

cv::Matx33d readMatrix(const Storage& storage, const char* key) {
  const auto numbers = readNumbers(storage, key);
  const cv::FileNode rows = storage[key]["rows"];
  if (numbers.size() != 9 || (rows.isInt() && int(rows) != 3)) wrongShape(storage, key, "3 x 3");
  return cv::Matx33d(numbers.data());
}

cv::Vec3d readVector(const Storage& storage, const char* key) {
  const auto numbers = readNumbers(storage, key);
  if (numbers.size() != 3) wrongShape(storage, key, "3 numbers");
  return {numbers[0], numbers[1], numbers[2]};
}

cv::Mat readDistortion(const Storage& storage, const char* key) {
  const auto numbers = readNumbers(storage, key);
  const bool none = std::all_of(numbers.begin(), numbers.end(), [](double d) { return d == 0; });
  return none ? cv::Mat() : cv::Mat(numbers, true).reshape(1, 1);
}

std::optional<cv::Size> readImageSize(const Storage& storage) {
  constexpr int largest = 1 << 15;
  cv::Size size;
  if (storage.has("image_size")) {
    const auto numbers = readNumbers(storage, "image_size");
    if (numbers.size() != 2) wrongShape(storage, "image_size", "width and height");
    size = {cv::saturate_cast<int>(numbers[0]), cv::saturate_cast<int>(numbers[1])};
  } else if (storage.has("image_width") && storage.has("image_height")) {
    const cv::FileNode width = storage["image_width"], height = storage["image_height"];
    if (width.isInt() && height.isInt()) size = {int(width), int(height)};
  } else {
    return std::nullopt;
  }
  if (size.width <= 0 || size.height <= 0 || size.width > largest || size.height > largest) {
    wrongShape(storage, storage.has("image_size") ? "image_size" : "image_width, image_height",
               "the size of the calibrated images in pixels");
  }
  return size;
}

// intrinsics.yml <-> extrinsics.yml, in whichever format the other half was written.
Storage openSibling(const Storage& storage, const std::string& name, const char* missingKey) {
  const fs::path folder = storage.file.parent_path();
  for (const char* extension : {".yml", ".yaml", ".xml"}) {
    const fs::path file = folder / (name + extension);
    std::error_code fault;
    if (file == storage.file || !fs::is_regular_file(file, fault)) continue;
    return open(file, readCalibrationText(file));
  }
  throw Error(storage.file.string(),
              std::string("the key ") + missingKey + " is missing, and there is no " + name +
                  ".yml beside it",
              "A stereo calibration has M1, D1, M2, D2, R and T.");
}

}  // namespace

StereoRig parseOpenCvCalibration(const fs::path& file, const std::string& text) {
  const Storage given = open(file, text);
  const Storage intrinsics = given.has("M1") ? given : openSibling(given, "intrinsics", "M1");
  const Storage extrinsics = given.has("R") ? given : openSibling(given, "extrinsics", "R");
  StereoRig rig;
  rig.leftMatrix = readMatrix(intrinsics, "M1");
  rig.rightMatrix = readMatrix(intrinsics, "M2");
  rig.leftDistortion = readDistortion(intrinsics, "D1");
  rig.rightDistortion = readDistortion(intrinsics, "D2");
  rig.rotation = readMatrix(extrinsics, "R");
  rig.translation = readVector(extrinsics, "T");
  if (const auto size = readImageSize(intrinsics)) {
    rig.imageSize = *size;
  } else if (const auto other = readImageSize(extrinsics)) {
    rig.imageSize = *other;
  }
  return rig;
}

}  // namespace boomwatch
