#include "simulation/demo_export.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "base/error.h"
#include "frame/stereo_rig.h"
#include "report/partial_folder.h"
#include "simulation/demo_camera.h"
#include "simulation/demo_source.h"
#include "simulation/truth_json.h"
#include "simulation/yard/yard_truth.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

void writeImage(const fs::path& file, const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  // Fast rather than small: the zlib level is most of the time.
  cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1});
  writeBytes(file, bytes);
}

std::string nameOf(std::size_t index) {
  const std::string digits = std::to_string(index);
  return std::string(6 - std::min<std::size_t>(6, digits.size()), '0') + digits + ".png";
}

std::string matrix(const char* key, int rows, int columns, const double* values) {
  std::string text = std::string(key) + ": !!opencv-matrix\n   rows: " + std::to_string(rows) +
                     "\n   cols: " + std::to_string(columns) + "\n   dt: d\n   data: [";
  for (int k = 0; k < rows * columns; ++k) {
    if (k > 0) text += ", ";
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%.17g", values[k]);
    text += number.data();
  }
  return text + "]\n";
}

std::string calibrationOf(const StereoRig& rig) {
  constexpr std::array<double, 5> none{};
  return "%YAML:1.0\n---\nimage_width: " + std::to_string(rig.imageSize.width) +
         "\nimage_height: " + std::to_string(rig.imageSize.height) + "\n" +
         matrix("M1", 3, 3, rig.leftMatrix.val) + matrix("D1", 1, 5, none.data()) +
         matrix("M2", 3, 3, rig.rightMatrix.val) + matrix("D2", 1, 5, none.data()) +
         matrix("R", 3, 3, rig.rotation.val) + matrix("T", 3, 1, rig.translation.val);
}

/// Of every demo that gives clouds.
std::string intrinsicsOf(const PinholeCamera& camera) {
  const std::array<double, 9> k{camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  return "%YAML:1.0\n---\n" + matrix("camera_matrix", 3, 3, k.data()) + "depth_factor: 1000.\n";
}

/// CV_16UC1, 0 where `image` (CV_32FC1) is no number.
cv::Mat sixteenBits(const cv::Mat& image, double scale) {
  cv::Mat result;
  image.convertTo(result, CV_16U, scale);
  result.setTo(0, image != image);  // NaN
  return result;
}

cv::Mat depthOf(const Cloud& cloud) {
  cv::Mat depth(cloud.height, cloud.width, CV_32FC1);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) depth.at<float>(v, u) = cloud.at(u, v).z();
  }
  return depth;
}

std::unique_ptr<FrameSource> openDemo(const DemoExport& what) {
  std::string demo = what.demo;
  const bool yard = demo.substr(0, demo.find(',')) == "yard";
  if (yard && what.frames && demo.find(",frames=") == std::string::npos) {
    demo += ",frames=" + std::to_string(*what.frames);
  }
  return openDemoSource(demo, "demo:" + demo);
}

class Writer {
 public:
  Writer(const PartialFolder& folder, const DemoExport& what) : m_folder(folder), m_what(what) {}

  void write(const Frame& frame) {
    const std::string name = nameOf(frame.sequence);
    if (frame.rig) {
      writeImage(m_folder.sub("left") / name, frame.left);
      writeImage(m_folder.sub("right") / name, frame.right);
      m_rig = frame.rig;
    } else {
      writeImage(m_folder.sub("colour") / name, frame.left);
      writeImage(m_folder.sub("depth") / name, sixteenBits(depthOf(*frame.cloud), 1000.0));
    }
    if (const auto& yard = frame.truth->yard; yard && m_what.truthImages) {
      writeImage(m_folder.sub("truth/depth") / name, sixteenBits(yard->depth, 1000.0));
      writeImage(m_folder.sub("truth/disparity") / name, sixteenBits(yard->disparity(), 256.0));
      writeImage(m_folder.sub("truth/kind") / name, yard->kind);
    }
    m_truth += truthJson(frame) + "\n";
    m_stamps += std::to_string(frame.stamp) + "\n";
  }

  void close() const {
    if (m_rig) {
      writeText(m_folder.path() / "calibration.yaml", calibrationOf(*m_rig));
      writeText(m_folder.path() / "timestamps.txt", m_stamps);
    } else {
      writeText(m_folder.path() / "intrinsics.yaml", intrinsicsOf(demoCamera));
    }
    writeText(m_folder.path() / "truth.jsonl", m_truth);
  }

 private:
  const PartialFolder& m_folder;
  const DemoExport& m_what;
  std::shared_ptr<const StereoRig> m_rig;
  std::string m_truth, m_stamps;
};

}  // namespace

bool exportDemo(const DemoExport& what, const ExportProgress& progress) {
  const fs::path target = emptyFolder(what.folder);
  const auto source = openDemo(what);
  const std::size_t most = source->info().frameCount.value_or(0);
  const std::size_t frames = what.frames.value_or(most);
  if (frames < 1 || frames > most) {
    throw Error("--frames",
                std::to_string(frames) + " frames are asked for, but " + source->info().address +
                    " has " + std::to_string(most),
                "Give 1 to " + std::to_string(most) + ".");
  }
  PartialFolder folder(target);
  Writer writer(folder, what);
  for (std::size_t k = 0; k < frames; ++k) {
    const ReadResult read = source->next({});
    if (!read.frame) throw std::runtime_error(source->info().address + ": " + read.message);
    writer.write(*read.frame);
    if (!progress(k + 1, frames)) return false;
  }
  writer.close();
  folder.finish();
  return true;
}

}  // namespace boomwatch
