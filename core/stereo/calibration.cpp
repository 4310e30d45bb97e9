#include "stereo/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "files/file_bytes.h"
#include "stereo/opencv_calibration.h"
#include "stereo/text_calibration.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

// A calibration takes a few kilobytes.
constexpr std::size_t maxFile = 256 * 1024;
// Wider than any rig; a calibration in millimetres lands beyond it.
constexpr double maxBaseline = 10.0;
constexpr double rotationTolerance = 1e-3;

void checkCamera(const std::string& where, const std::string& key, const cv::Matx33d& m) {
  const std::string remedy = "Calibrate anew, or correct " + key + ".";
  for (const double value : m.val) {
    if (!std::isfinite(value)) throw Error(where, key + " holds a value that is no number", remedy);
  }
  if (m(0, 0) <= 0 || m(1, 1) <= 0) {
    throw Error(where, key + " has a focal length that is zero or negative", remedy);
  }
  // The principal point is near the middle: with this little the picture would be 174 degrees wide.
  if (m(0, 0) < 0.05 * m(0, 2) || m(1, 1) < 0.05 * m(1, 2)) {
    throw Error(where,
                key + " has a focal length of " + std::to_string(m(0, 0)) +
                    " pixels, too "
                    "short for its pictures",
                "The focal length must be in pixels, not in millimetres.");
  }
  // OpenCV's model and Eq. 5 know no skew.
  const bool pinhole = m(0, 1) == 0 && m(1, 0) == 0 && m(2, 0) == 0 && m(2, 1) == 0 && m(2, 2) == 1;
  if (!pinhole) throw Error(where, key + " is not of the form [f 0 c; 0 f c; 0 0 1]", remedy);
}

void checkDistortion(const std::string& where, const std::string& key, const cv::Mat& d) {
  constexpr std::array<std::size_t, 6> known{0, 4, 5, 8, 12, 14};
  if (std::find(known.begin(), known.end(), d.total()) == known.end()) {
    throw Error(where, key + " has " + std::to_string(d.total()) + " coefficients",
                "OpenCV knows 0, 4, 5, 8, 12 or 14.");
  }
  if (!cv::checkRange(d)) {
    throw Error(where, key + " holds a value that is no number", "Calibrate anew.");
  }
}

void checkRotation(const std::string& where, const cv::Matx33d& r) {
  const double error = cv::norm(r * r.t() - cv::Matx33d::eye(), cv::NORM_INF);
  if (!(error < rotationTolerance) || cv::determinant(r) < 0) {
    throw Error(where, "R is not a rotation", "Calibrate anew, or correct R.");
  }
}

void checkBaseline(const std::string& where, const StereoRig& rig) {
  const double baseline = rig.baseline();
  if (!std::isfinite(baseline) || baseline <= 0) {
    throw Error(where, "T gives a baseline that is zero or no number", "Correct T, in metres.");
  }
  if (baseline > maxBaseline) {
    throw Error(where, "T gives a baseline of " + std::to_string(baseline) + " m",
                "T must be in metres: divide by 1000 if it is in millimetres.");
  }
  // Where the right camera stands, seen from the left one: right = R left + T = 0.
  const cv::Vec3d right = -(rig.rotation.t() * rig.translation);
  if (std::abs(right[0]) < std::max(std::abs(right[1]), std::abs(right[2]))) {
    throw Error(where, "T puts the cameras above or behind one another, not side by side",
                "Turn the images and calibrate a horizontal pair.");
  }
  if (right[0] < 0) {
    throw Error(where, "T puts the right camera to the left of the left one",
                "Left and right are swapped: exchange the cameras, or calibrate anew.");
  }
}

// An OpenCV file of a pair that needs no rectification: remapping would only blur it.
bool isRectified(const StereoRig& rig) {
  const auto& l = rig.leftMatrix;
  const auto& r = rig.rightMatrix;
  return rig.leftDistortion.empty() && rig.rightDistortion.empty() &&
         rig.rotation == cv::Matx33d::eye() && rig.translation[1] == 0 && rig.translation[2] == 0 &&
         l(0, 0) == r(0, 0) && l(1, 1) == r(1, 1) && l(1, 2) == r(1, 2);
}

bool looksLikeOpenCv(const fs::path& file, const std::string& text) {
  const auto extension = file.extension();
  return text.starts_with("%YAML") || text.starts_with("<?xml") || extension == ".yml" ||
         extension == ".yaml" || extension == ".xml";
}

StereoRig parse(const fs::path& file, const std::string& text, CameraPair pair) {
  if (looksLikeOpenCv(file, text)) return parseOpenCvCalibration(file, text);
  if (text.find("cam0") != std::string::npos) return parseMiddleburyCalibration(file, text);
  return parseKittiCalibration(file, text, pair);
}

}  // namespace

void checkRig(const std::string& where, const StereoRig& rig) {
  checkCamera(where, "the left camera's matrix (M1, P0, cam0)", rig.leftMatrix);
  checkCamera(where, "the right camera's matrix (M2, P1, cam1)", rig.rightMatrix);
  checkDistortion(where, "D1", rig.leftDistortion);
  checkDistortion(where, "D2", rig.rightDistortion);
  checkRotation(where, rig.rotation);
  checkBaseline(where, rig);
}

std::string readCalibrationText(const fs::path& file) {
  const std::string text = readFileBytes(file, maxFile);
  const std::string remedy = "Give a stereo calibration: OpenCV YAML or XML, or a calib.txt.";
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw Error(file.string(), "this is empty", remedy);
  }
  if (text.find('\0') != std::string::npos) {
    throw Error(file.string(), "this is not a text file", remedy);
  }
  return text;
}

StereoRig readCalibration(const fs::path& file, CameraPair pair) {
  StereoRig rig = parse(file, readCalibrationText(file), pair);
  checkRig(file.string(), rig);
  rig.rectified = rig.rectified || isRectified(rig);
  return rig;
}

std::optional<fs::path> findCalibration(const fs::path& folder) {
  constexpr std::array names{
      "calibration.yaml", "calibration.yml", "calibration.xml", "stereo.yaml",
      "stereo.yml",       "stereo.xml",      "calib.yaml",      "calib.yml",
      "calib.xml",        "calib.txt",       "intrinsics.yml",  "intrinsics.yaml",
      "intrinsics.xml",   "extrinsics.yml",  "extrinsics.yaml", "extrinsics.xml"};
  std::error_code fault;
  for (const char* name : names) {
    if (fs::is_regular_file(folder / name, fault)) return folder / name;
  }
  return std::nullopt;
}

}  // namespace boomwatch
