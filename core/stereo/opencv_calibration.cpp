#include "stereo/opencv_calibration.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/error.h"
#include "files/opencv_file.h"
#include "stereo/calibration.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

constexpr const char* wanted = "A stereo calibration has M1, D1, M2, D2, R and T.";

struct Part {
  fs::path file;
  OpencvFile content;

  bool has(const char* key) const { return content.matrices.contains(key); }
};

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw Error(file.string(), what, wanted);
}

cv::Mat matrixOf(const Part& part, const std::string& key) {
  const auto found = part.content.matrices.find(key);
  if (found != part.content.matrices.end()) return found->second;
  refuse(part.file, "the key " + key + " is missing, or does not hold rows x cols numbers");
}

cv::Matx33d squareOf(const Part& part, const std::string& key) {
  const cv::Mat matrix = matrixOf(part, key);
  if (matrix.size() != cv::Size(3, 3)) refuse(part.file, key + " is not a 3 x 3 matrix");
  return matrix;
}

cv::Vec3d vectorOf(const Part& part, const std::string& key) {
  const cv::Mat matrix = matrixOf(part, key);
  if (matrix.total() != 3) refuse(part.file, key + " does not hold 3 numbers");
  return cv::Vec3d(matrix.ptr<double>());
}

cv::Mat distortionOf(const Part& part, const std::string& key) {
  const cv::Mat matrix = matrixOf(part, key);
  return cv::countNonZero(matrix) == 0 ? cv::Mat() : matrix.reshape(1, 1);
}

// `image_size` as OpenCV writes a cv::Size: "[ 640, 480 ]" in YAML, "640 480" in XML.
std::optional<cv::Size> sizeInText(const std::string& text) {
  constexpr std::string_view key = "image_size";
  auto at = text.find(key);
  if (at == std::string::npos) return std::nullopt;
  at += key.size();
  cv::Size size;
  for (int* side : {&size.width, &size.height}) {
    at = std::min(text.find_first_not_of(":>[, \t\r\n", at), text.size());
    const auto parsed = std::from_chars(text.data() + at, text.data() + text.size(), *side);
    at = static_cast<std::size_t>(parsed.ptr - text.data());
  }
  return size;
}

cv::Size imageSizeOf(const Part& part, const std::string& text) {
  constexpr int largest = 1 << 15;
  const auto& numbers = part.content.numbers;
  std::optional<cv::Size> size = sizeInText(text);
  if (numbers.contains("image_width") && numbers.contains("image_height")) {
    size = cv::Size(cv::saturate_cast<int>(numbers.at("image_width")),
                    cv::saturate_cast<int>(numbers.at("image_height")));
  }
  if (!size) return {};
  if (size->width > 0 && size->height > 0 && size->width <= largest && size->height <= largest) {
    return *size;
  }
  throw Error(part.file.string(),
              "image_width and image_height, or image_size, are not the size of an image",
              "Give the size of the calibrated images in pixels.");
}

// intrinsics.yml <-> extrinsics.yml, in whichever format the other half was written.
Part openSibling(const Part& given, const std::string& name, const std::string& missingKey) {
  for (const char* extension : {".yml", ".yaml", ".xml"}) {
    const fs::path file = given.file.parent_path() / (name + extension);
    std::error_code fault;
    if (file == given.file || !fs::is_regular_file(file, fault)) continue;
    return {file, readOpencvFile(file)};
  }
  refuse(given.file, "the key " + missingKey +
                         " is missing, or does not hold rows x cols numbers, and there is no " +
                         name + ".yml beside it");
}

}  // namespace

StereoRig parseOpenCvCalibration(const fs::path& file, const std::string& text) {
  const Part given{file, readOpencvFile(file)};
  const Part intrinsics = given.has("M1") ? given : openSibling(given, "intrinsics", "M1");
  const Part extrinsics = given.has("R") ? given : openSibling(given, "extrinsics", "R");
  StereoRig rig;
  rig.leftMatrix = squareOf(intrinsics, "M1");
  rig.rightMatrix = squareOf(intrinsics, "M2");
  rig.leftDistortion = distortionOf(intrinsics, "D1");
  rig.rightDistortion = distortionOf(intrinsics, "D2");
  rig.rotation = squareOf(extrinsics, "R");
  rig.translation = vectorOf(extrinsics, "T");
  rig.imageSize = imageSizeOf(given, text);
  if (rig.imageSize.empty()) rig.imageSize = imageSizeOf(intrinsics, "");
  return rig;
}

}  // namespace boomwatch
