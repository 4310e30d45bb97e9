#include "stereo/text_calibration.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

#include "base/error.h"
#include "files/line_reader.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

// Numbers parted by blanks, commas, semicolons or brackets.
std::vector<double> numbersIn(const fs::path& file, const std::string& key, std::string_view text) {
  constexpr std::string_view separators = " \t\r,;[]";
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;
       at = text.find_first_not_of(separators, at)) {
    const auto end = std::min(text.find_first_of(separators, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const auto value = toNumber<double>(word);
    if (!value) {
      throw Error(file.string(),
                  key + ": '" + std::string(word.substr(0, 40)) + "' is not a number",
                  "Give KITTI's or Middlebury's calib.txt, or an OpenCV YAML file.");
    }
    numbers.push_back(*value);
    at = end;
  }
  return numbers;
}

using Entries = std::map<std::string, std::string>;

// Lines of `key<separator>value`; a line without one gets its number as key: "line 1".
Entries entriesOf(const std::string& text, char separator) {
  Entries entries;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line);) {
    const auto begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    const auto at = line.find(separator);
    if (at == std::string::npos) {
      entries.emplace("line " + std::to_string(number), line);
    } else {
      entries.emplace(line.substr(begin, line.find_last_not_of(" \t", at - 1) + 1 - begin),
                      line.substr(at + 1));
    }
    ++number;
  }
  return entries;
}

std::vector<double> valueOf(const fs::path& file, const Entries& entries, const std::string& key,
                            std::size_t count) {
  const auto found = entries.find(key);
  if (found == entries.end()) {
    throw Error(file.string(), key + " is missing",
                "Give KITTI's calib.txt (P0 and P1), Middlebury's (cam0, cam1, baseline), or an "
                "OpenCV YAML file.");
  }
  const auto numbers = numbersIn(file, key, found->second);
  if (numbers.size() != count) {
    throw Error(file.string(),
                key + " must hold " + std::to_string(count) + " numbers, not " +
                    std::to_string(numbers.size()),
                "Correct the line.");
  }
  return numbers;
}

double numberOf(const fs::path& file, const Entries& entries, const std::string& key) {
  return valueOf(file, entries, key, 1).front();
}

void checkRows(const fs::path& file, const StereoRig& rig) {
  const auto& l = rig.leftMatrix;
  const auto& r = rig.rightMatrix;
  // NaN passes here; readCalibration names it.
  const bool differ = std::abs(l(0, 0) - r(0, 0)) > 1e-3 * std::abs(l(0, 0)) ||
                      std::abs(l(1, 1) - r(1, 1)) > 1e-3 * std::abs(l(1, 1)) ||
                      std::abs(l(1, 2) - r(1, 2)) > 0.5;
  if (differ) {
    throw Error(file.string(), "the two cameras differ in focal length or in cy",
                "A rectified pair shares them; give an OpenCV YAML file for an unrectified one.");
  }
}

cv::Matx33d cameraOf(const std::vector<double>& p) {
  return {p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10]};
}

}  // namespace

StereoRig parseKittiCalibration(const fs::path& file, const std::string& text, CameraPair pair) {
  const Entries entries = entriesOf(text, ':');
  const bool bare = entries.contains("line 1") && !entries.contains("P0");
  const bool first = bare || pair == CameraPair::First;
  const auto left = valueOf(file, entries, bare ? "line 1" : first ? "P0" : "P2", 12);
  const auto right = valueOf(file, entries, bare ? "line 2" : first ? "P1" : "P3", 12);
  StereoRig rig;
  rig.rectified = true;
  rig.leftMatrix = cameraOf(left);
  rig.rightMatrix = cameraOf(right);
  // P = K [I | t]: the first row's last element is f times the camera's offset along x.
  rig.translation = {(right[3] - left[3]) / left[0], 0, 0};
  if (left[0] == 0) rig.translation[0] = -1;  // the zero focal length is what must be named
  checkRows(file, rig);
  return rig;
}

StereoRig parseMiddleburyCalibration(const fs::path& file, const std::string& text) {
  const Entries entries = entriesOf(text, '=');
  StereoRig rig;
  rig.rectified = true;
  rig.leftMatrix = cv::Matx33d(valueOf(file, entries, "cam0", 9).data());
  rig.rightMatrix = cv::Matx33d(valueOf(file, entries, "cam1", 9).data());
  rig.translation = {-numberOf(file, entries, "baseline") / 1000, 0, 0};
  checkRows(file, rig);
  if (entries.contains("doffs")) {
    const double doffs = numberOf(file, entries, "doffs");
    if (!(std::abs(rig.rightMatrix(0, 2) - rig.leftMatrix(0, 2) - doffs) <= 0.5)) {
      throw Error(file.string(), "doffs is not the difference of cam1's and cam0's cx",
                  "Correct whichever is wrong.");
    }
  }
  if (entries.contains("width") && entries.contains("height")) {
    const double width = numberOf(file, entries, "width");
    const double height = numberOf(file, entries, "height");
    if (!(width >= 1 && width <= 32768 && height >= 1 && height <= 32768)) {
      throw Error(file.string(), "width and height are not the size of an image",
                  "Give them in pixels.");
    }
    rig.imageSize = {static_cast<int>(width), static_cast<int>(height)};
  }
  return rig;
}

}  // namespace boomwatch
