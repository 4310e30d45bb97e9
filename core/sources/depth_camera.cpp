#include "sources/depth_camera.h"

#include <cmath>

#include "frame/error.h"
#include "sources/file_bytes.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxFile = 1 << 20;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw Error(file.string(), what,
              "Give OpenCV's YAML or XML with camera_matrix, or fx, fy, cx and cy.");
}

cv::Mat matrixIn(const cv::FileStorage& storage, const std::filesystem::path& file) {
  for (const char* key : {"camera_matrix", "M1", "intrinsic", "K"}) {
    const cv::FileNode node = storage[key];
    if (node.empty()) continue;
    const cv::Mat matrix = node.mat();
    if (matrix.rows != 3 || matrix.cols != 3 || matrix.channels() != 1) {
      refuse(file, std::string(key) + " is not a 3 x 3 matrix");
    }
    cv::Mat result;
    matrix.convertTo(result, CV_64F);
    return result;
  }
  return {};
}

double numberIn(const cv::FileStorage& storage, const char* key,
                const std::filesystem::path& file) {
  const cv::FileNode node = storage[key];
  if (node.isReal() || node.isInt()) return node.real();
  refuse(file, std::string(key) + " is missing or not a number");
}

DepthCamera parse(const cv::FileStorage& storage, const std::filesystem::path& file) {
  DepthCamera camera;
  const cv::Mat matrix = matrixIn(storage, file);
  if (!matrix.empty()) {
    camera = {matrix.at<double>(0, 0), matrix.at<double>(1, 1), matrix.at<double>(0, 2),
              matrix.at<double>(1, 2)};
  } else if (storage["fx"].empty()) {
    refuse(file, "there is no camera_matrix, M1, intrinsic or K, and no fx");
  } else {
    camera = {numberIn(storage, "fx", file), numberIn(storage, "fy", file),
              numberIn(storage, "cx", file), numberIn(storage, "cy", file)};
  }
  if (!storage["depth_factor"].empty()) {
    camera.unitsPerMetre = numberIn(storage, "depth_factor", file);
  }
  return camera;
}

void check(const DepthCamera& camera, const std::filesystem::path& file) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!positive(camera.fx) || !positive(camera.fy)) refuse(file, "a focal length is not above 0");
  if (!std::isfinite(camera.cx) || !std::isfinite(camera.cy)) {
    refuse(file, "the principal point is not a number");
  }
  if (!positive(camera.unitsPerMetre)) refuse(file, "depth_factor is not above 0");
}

}  // namespace

DepthCamera readDepthCamera(const std::filesystem::path& file) {
  const std::string text = readFileBytes(file, maxFile);
  DepthCamera camera;
  try {
    const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    if (!storage.isOpened()) refuse(file, "it is neither YAML, XML nor JSON as OpenCV writes it");
    camera = parse(storage, file);
  } catch (const cv::Exception& fault) {
    refuse(file, "it is not as OpenCV writes it: " + fault.err);
  }
  check(camera, file);
  return camera;
}

Cloud cloudFromDepth(const cv::Mat& depth, const DepthCamera& camera) {
  Cloud cloud;
  cloud.width = depth.cols;
  cloud.height = depth.rows;
  cloud.points.reserve(depth.total());
  for (int v = 0; v < depth.rows; ++v) {
    const auto* row = depth.ptr<std::uint16_t>(v);
    for (int u = 0; u < depth.cols; ++u) {
      if (row[u] == 0) {
        cloud.points.push_back(unmeasuredPoint());
        continue;
      }
      const double z = row[u] / camera.unitsPerMetre;
      cloud.points.push_back(
          Eigen::Vector3d((u - camera.cx) * z / camera.fx, (v - camera.cy) * z / camera.fy, z)
              .cast<float>());
    }
  }
  return cloud;
}

}  // namespace boomwatch
