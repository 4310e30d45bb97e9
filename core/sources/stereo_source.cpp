#include "sources/stereo_source.h"

#include <cmath>
#include <fstream>
#include <vector>

#include "frame/error.h"
#include "sources/file_sequence.h"
#include "sources/image_sequence.h"
#include "sources/stereo_files.h"
#include "sources/text_scan.h"
#include "sources/video_stream.h"
#include "stereo/calibration.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;
using Stamps = std::vector<double>;

constexpr double imageRate = 10.0;

std::string text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

StereoRig calibrationOf(const StereoFiles& files, const SourceOptions& options) {
  if (!options.calibration.empty()) return readCalibration(options.calibration, files.cameras);
  auto found = findCalibration(files.folder);
  if (!found) found = findCalibration(files.folder.parent_path());
  if (found) return readCalibration(*found, files.cameras);
  throw Error(files.folder.string(), "there is no calibration in this folder",
              "Put calibration.yaml (OpenCV: M1 D1 M2 D2 R T, T in metres) or calib.txt (KITTI, "
              "Middlebury) into it, or name one with --calibration.");
}

// Seconds, the first word of each line; '#' begins a comment.
Stamps readStamps(const fs::path& file, std::size_t count) {
  Stamps stamps;
  std::ifstream stream(file);
  std::string line;
  for (std::size_t number = 1; stamps.size() < count && std::getline(stream, line); ++number) {
    const auto parts = words(line);
    if (parts.empty() || parts.front().starts_with('#')) continue;
    const auto seconds = toNumber<double>(parts.front());
    if (!seconds || !std::isfinite(*seconds) || (!stamps.empty() && *seconds < stamps.back())) {
      throw Error(file.string() + " line " + std::to_string(number),
                  "this is not a time in seconds after the line above", "Correct or remove it.");
    }
    stamps.push_back(*seconds);
  }
  if (stamps.size() == count) return stamps;
  throw Error(file.string(),
              "there are " + std::to_string(stamps.size()) + " times for " + std::to_string(count) +
                  " pairs",
              "Complete it, or remove it.");
}

Stamps pairStamps(const StereoFiles& files, std::size_t count, double rate) {
  for (const char* name : {"timestamps.txt", "times.txt"}) {
    std::error_code fault;
    if (fs::is_regular_file(files.folder / name, fault)) {
      return readStamps(files.folder / name, count);
    }
  }
  if (!files.video) return stampsOf(files.left, rate);
  Stamps stamps(count);
  for (std::size_t i = 0; i < count; ++i) stamps[i] = static_cast<double>(i) / rate;
  return stamps;
}

double meanRate(const Stamps& stamps, double otherwise) {
  const double span = stamps.back() - stamps.front();
  return span > 0 ? static_cast<double>(stamps.size() - 1) / span : otherwise;
}

class StereoSource : public FrameSource {
 public:
  StereoSource(const StereoFiles& files, std::string address, const StereoRig& rig)
      : m_rig(std::make_shared<StereoRig>(rig)) {
    m_left = openStream(files.left, files.video);
    m_right = openStream(files.right, files.video);
    checkStreams(files);
    const double rate = m_left->rate().value_or(imageRate);
    m_stamps = pairStamps(files, m_left->count(), rate);
    m_info = {std::move(address), m_left->count(), meanRate(m_stamps, rate), false};
    if (!m_rig->imageSize.empty()) m_size = m_rig->imageSize;
  }

  SourceInfo info() const override { return m_info; }

  bool seek(std::size_t index) override {
    if (index >= m_stamps.size()) return false;
    m_next = index;
    return true;
  }

  ReadResult next(std::chrono::milliseconds) override {
    if (m_next >= m_stamps.size()) return {};
    const StreamImage left = m_left->read(m_next);
    const StreamImage right = m_right->read(m_next);
    if (left.end || right.end) return {};
    const std::size_t index = m_next++;
    const std::string fault = faultOf(index, left, right);
    if (!fault.empty()) return {ReadResult::Status::Bad, nullptr, fault, 0};
    auto frame = std::make_shared<Frame>();
    frame->sequence = index;
    frame->stamp = m_stamps[index];
    frame->left = left.image;
    frame->right = right.image;
    frame->rig = m_rig;
    return {ReadResult::Status::Ok, frame, "", 0};
  }

 private:
  static std::unique_ptr<ImageStream> openStream(const std::vector<fs::path>& files, bool video) {
    if (video) return std::make_unique<VideoStream>(files.front());
    return std::make_unique<ImageSequence>(files);
  }

  void checkStreams(const StereoFiles& files) const {
    const auto left = m_left->count(), right = m_right->count();
    if (left != right) {
      throw Error(files.left.front().string(),
                  "it has " + std::to_string(left) + " frames, but the right video has " +
                      std::to_string(right),
                  "Cut both videos to the same frames.");
    }
    const auto size = m_left->size();
    if (size && !m_rig->imageSize.empty() && *size != m_rig->imageSize) {
      throw Error(files.left.front().string(),
                  "the pictures are " + text(*size) + ", but the calibration is for " +
                      text(m_rig->imageSize),
                  "Give the calibration of this recording.");
    }
  }

  std::string faultOf(std::size_t index, const StreamImage& left, const StreamImage& right) {
    if (!left.fault.empty()) return left.fault;
    if (!right.fault.empty()) return right.fault;
    const cv::Size size = left.image.size();
    const std::string pair = m_info.address + ", pair " + std::to_string(index + 1) + ": ";
    if (size != right.image.size()) {
      return pair + "left is " + text(size) + " and right is " + text(right.image.size()) +
             ". Both must have the same size.";
    }
    if (!m_size) m_size = size;
    if (size == *m_size) return "";
    return pair + "the pictures changed from " + text(*m_size) + " to " + text(size) +
           ". All pictures of a recording must have the same size.";
  }

  std::shared_ptr<const StereoRig> m_rig;
  std::unique_ptr<ImageStream> m_left;
  std::unique_ptr<ImageStream> m_right;
  Stamps m_stamps;
  SourceInfo m_info;
  std::optional<cv::Size> m_size;  ///< absent until the first pair that could be read
  std::size_t m_next = 0;
};

}  // namespace

std::unique_ptr<FrameSource> openStereoSource(const std::string& path, const std::string& address,
                                              const SourceOptions& options) {
  const StereoFiles files = findStereoFiles(path);
  return std::make_unique<StereoSource>(files, address, calibrationOf(files, options));
}

}  // namespace boomwatch
