#include "simulation/demo_export.h"

#include <algorithm>
#include <functional>
#include <opencv2/core/persistence.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "base/error.h"
#include "frame/stereo_rig.h"
#include "report/partial_folder.h"
#include "simulation/demo_camera.h"
#include "simulation/demo_source.h"
#include "simulation/truth_json.h"
#include "simulation/yard/yard_source.h"

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

/// A file in OpenCV's own format, written by `fill`.
std::string yamlOf(const std::function<void(cv::FileStorage&)>& fill) {
  cv::FileStorage storage(
      "", cv::FileStorage::WRITE | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
  fill(storage);
  return storage.releaseAndGetString();
}

std::string calibrationOf(const StereoRig& rig) {
  const cv::Mat undistorted = cv::Mat::zeros(1, 5, CV_64F);
  return yamlOf([&](cv::FileStorage& file) {
    file << "image_width" << rig.imageSize.width << "image_height" << rig.imageSize.height;
    file << "M1" << cv::Mat(rig.leftMatrix) << "D1" << undistorted;
    file << "M2" << cv::Mat(rig.rightMatrix) << "D2" << undistorted;
    file << "R" << cv::Mat(rig.rotation) << "T" << cv::Mat(rig.translation);
  });
}

/// Of every demo that gives clouds.
std::string intrinsicsOf(const PinholeCamera& camera) {
  const cv::Matx33d matrix(camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
  return yamlOf([&](cv::FileStorage& file) {
    file << "camera_matrix" << cv::Mat(matrix) << "depth_factor" << 1000.0;
  });
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

/// The frames of a demo, with the truth where it is a yard.
class Demo {
 public:
  explicit Demo(const DemoExport& what) {
    std::string name = what.demo;
    const auto comma = std::min(name.find(','), name.size());
    const bool isYard = name.substr(0, comma) == "yard";
    if (isYard && what.frames && name.find(",frames=") == std::string::npos) {
      name += ",frames=" + std::to_string(*what.frames);
    }
    const std::string address = "demo:" + name;
    if (isYard) {
      m_yard = std::make_unique<YardSource>(name.substr(std::min(name.size(), comma + 1)), address);
    } else {
      m_other = openDemoSource(name, address);
    }
  }

  SourceInfo info() const { return m_yard ? m_yard->info() : m_other->info(); }
  /// In their order.
  YardFrame frame(std::size_t index) const {
    if (m_yard) return m_yard->at(index);
    const ReadResult read = m_other->next({});
    if (!read.frame) throw std::runtime_error(info().address + ": " + read.message);
    return {read.frame, nullptr};
  }

 private:
  std::unique_ptr<YardSource> m_yard;  ///< one of the two
  std::unique_ptr<FrameSource> m_other;
};

class Writer {
 public:
  Writer(const PartialFolder& folder, const DemoExport& what) : m_folder(folder), m_what(what) {}

  void write(const Frame& frame, const YardTruth* yard) {
    const std::string name = nameOf(frame.sequence);
    if (frame.rig) {
      writeImage(m_folder.sub("left") / name, frame.left);
      writeImage(m_folder.sub("right") / name, frame.right);
      m_rig = frame.rig;
    } else {
      writeImage(m_folder.sub("colour") / name, frame.left);
      writeImage(m_folder.sub("depth") / name, sixteenBits(depthOf(*frame.cloud), 1000.0));
    }
    if (yard && m_what.truthImages) {
      writeImage(m_folder.sub("truth/depth") / name, sixteenBits(yard->depth, 1000.0));
      writeImage(m_folder.sub("truth/disparity") / name, sixteenBits(yard->disparity(), 256.0));
      writeImage(m_folder.sub("truth/kind") / name, yard->kind);
    }
    m_truth += truthJson(frame, yard) + "\n";
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
  const Demo demo(what);
  const SourceInfo info = demo.info();
  const std::size_t most = info.frameCount.value_or(0);
  const std::size_t frames = what.frames.value_or(most);
  if (frames < 1 || frames > most) {
    throw Error("--frames",
                std::to_string(frames) + " frames are asked for, but " + info.address + " has " +
                    std::to_string(most),
                "Give 1 to " + std::to_string(most) + ".");
  }
  PartialFolder folder(target);
  Writer writer(folder, what);
  for (std::size_t k = 0; k < frames; ++k) {
    const YardFrame next = demo.frame(k);
    writer.write(*next.frame, next.truth.get());
    if (!progress(k + 1, frames)) return false;
  }
  writer.close();
  folder.finish();
  return true;
}

}  // namespace boomwatch
