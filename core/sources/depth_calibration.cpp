#include "sources/depth_calibration.h"

#include <cmath>

#include "base/error.h"
#include "files/opencv_file.h"

namespace boomwatch {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw Error(file.string(), what,
              "Give OpenCV's YAML or XML with camera_matrix, or fx, fy, cx and cy.");
}

cv::Mat matrixIn(const OpencvFile& content, const std::filesystem::path& file) {
  for (const char* key : {"camera_matrix", "M1", "intrinsic", "K"}) {
    const auto found = content.matrices.find(key);
    if (found == content.matrices.end()) continue;
    if (found->second.size() == cv::Size(3, 3)) return found->second;
    refuse(file, std::string(key) + " is not a 3 x 3 matrix");
  }
  return {};
}

double numberIn(const OpencvFile& content, const char* key, const std::filesystem::path& file) {
  const auto found = content.numbers.find(key);
  if (found != content.numbers.end()) return found->second;
  refuse(file, std::string(key) + " is missing or not a number");
}

DepthCalibration parse(const OpencvFile& content, const std::filesystem::path& file) {
  DepthCalibration calibration;
  PinholeCamera& camera = calibration.camera;
  const cv::Mat matrix = matrixIn(content, file);
  if (!matrix.empty()) {
    camera.fx = matrix.at<double>(0, 0);
    camera.fy = matrix.at<double>(1, 1);
    camera.cx = matrix.at<double>(0, 2);
    camera.cy = matrix.at<double>(1, 2);
  } else if (content.numbers.contains("fx")) {
    camera.fx = content.numbers.at("fx");
    camera.fy = numberIn(content, "fy", file);
    camera.cx = numberIn(content, "cx", file);
    camera.cy = numberIn(content, "cy", file);
  } else {
    refuse(file, "there is neither a matrix camera_matrix, M1, intrinsic or K, nor a number fx");
  }
  if (content.numbers.contains("depth_factor")) {
    calibration.unitsPerMetre = content.numbers.at("depth_factor");
  }
  return calibration;
}

void check(const DepthCalibration& calibration, const std::filesystem::path& file) {
  const PinholeCamera& camera = calibration.camera;
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!positive(camera.fx) || !positive(camera.fy)) refuse(file, "a focal length is not above 0");
  if (!std::isfinite(camera.cx) || !std::isfinite(camera.cy)) {
    refuse(file, "the principal point is not a number");
  }
  if (!positive(calibration.unitsPerMetre)) refuse(file, "depth_factor is not above 0");
}

}  // namespace

DepthCalibration readDepthCalibration(const std::filesystem::path& file) {
  const DepthCalibration calibration = parse(readOpencvFile(file), file);
  check(calibration, file);
  return calibration;
}

Cloud cloudFromDepth(const cv::Mat& depth, const DepthCalibration& calibration) {
  Cloud cloud;
  cloud.width = depth.cols;
  cloud.height = depth.rows;
  PinholeCamera camera = calibration.camera;
  camera.width = depth.cols;
  camera.height = depth.rows;
  cloud.camera = camera;
  cloud.points.reserve(depth.total());
  for (int v = 0; v < depth.rows; ++v) {
    const auto* row = depth.ptr<std::uint16_t>(v);
    for (int u = 0; u < depth.cols; ++u) {
      if (row[u] == 0) {
        cloud.points.push_back(unmeasuredPoint());
        continue;
      }
      const double z = row[u] / calibration.unitsPerMetre;
      cloud.points.push_back(
          Eigen::Vector3d((u - camera.cx) * z / camera.fx, (v - camera.cy) * z / camera.fy, z)
              .cast<float>());
    }
  }
  return cloud;
}

}  // namespace boomwatch
