#include "sources/stereo_source.h"

#include <cmath>
#include <fstream>
#include <vector>

#include "base/error.h"
#include "base/size_text.h"
#include "files/line_reader.h"
#include "sources/file_sequence.h"
#include "sources/image_sequence.h"
#include "sources/indexed_source.h"
#include "sources/stereo_files.h"
#include "sources/video_stream.h"
#include "stereo/calibration.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;
using Stamps = std::vector<double>;

constexpr double imageRate = 10.0;

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
      throw Error(file.string() + ", line " + std::to_string(number),
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

std::unique_ptr<ImageStream> openStream(const std::vector<fs::path>& files, bool video) {
  if (video) return std::make_unique<VideoStream>(files.front());
  return std::make_unique<ImageSequence>(files);
}

/// Two cameras' pictures that belong together by index.
struct StereoRecording {
  std::shared_ptr<const StereoRig> rig;
  std::unique_ptr<ImageStream> left;
  std::unique_ptr<ImageStream> right;
  Stamps stamps;  ///< one a pair
  double rate = imageRate;
};

void checkStreams(const StereoFiles& files, const StereoRecording& recording) {
  const auto left = recording.left->count(), right = recording.right->count();
  if (left != right) {
    throw Error(files.left.front().string(),
                "it has " + std::to_string(left) + " frames, but the right video has " +
                    std::to_string(right),
                "Cut both videos to the same frames.");
  }
  const auto size = recording.left->size();
  const cv::Size calibrated = recording.rig->imageSize;
  if (size && !calibrated.empty() && *size != calibrated) {
    throw Error(files.left.front().string(),
                "the pictures are " + sizeText(*size) + ", but the calibration is for " +
                    sizeText(calibrated),
                "Give the calibration of this recording.");
  }
}

StereoRecording openRecording(const StereoFiles& files, const StereoRig& rig) {
  StereoRecording recording{std::make_shared<StereoRig>(rig),
                            openStream(files.left, files.video),
                            openStream(files.right, files.video),
                            {},
                            imageRate};
  checkStreams(files, recording);
  const double rate = recording.left->rate().value_or(imageRate);
  recording.stamps = pairStamps(files, recording.left->count(), rate);
  recording.rate = meanRate(recording.stamps, rate);
  return recording;
}

class StereoSource : public IndexedSource {
 public:
  StereoSource(StereoRecording recording, const std::string& address)
      : IndexedSource(address, recording.stamps.size(), recording.rate),
        m_recording(std::move(recording)) {
    if (const cv::Size size = m_recording.rig->imageSize; !size.empty()) m_size = size;
  }

 protected:
  ReadResult read(std::size_t index) override {
    const StreamImage left = m_recording.left->read(index);
    const StreamImage right = m_recording.right->read(index);
    if (left.end || right.end) return end();
    if (std::string fault = faultOf(index, left, right); !fault.empty()) {
      return bad(std::move(fault));
    }
    auto frame = std::make_shared<Frame>();
    frame->sequence = index;
    frame->stamp = m_recording.stamps[index];
    frame->left = left.image;
    frame->right = right.image;
    frame->rig = m_recording.rig;
    return ok(std::move(frame));
  }

 private:
  std::string faultOf(std::size_t index, const StreamImage& left, const StreamImage& right) {
    if (!left.fault.empty()) return left.fault;
    if (!right.fault.empty()) return right.fault;
    const cv::Size size = left.image.size();
    const std::string pair = info().address + ", pair " + std::to_string(index + 1) + ": ";
    if (size != right.image.size()) {
      return pair + "left is " + sizeText(size) + " and right is " + sizeText(right.image.size()) +
             ". Both must have the same size.";
    }
    if (!m_size) m_size = size;
    if (size == *m_size) return "";
    return pair + "the pictures changed from " + sizeText(*m_size) + " to " + sizeText(size) +
           ". All pictures of a recording must have the same size.";
  }

  StereoRecording m_recording;
  std::optional<cv::Size> m_size;  ///< absent until the first pair that could be read
};

}  // namespace

std::unique_ptr<FrameSource> openStereoSource(const std::string& path, const std::string& address,
                                              const SourceOptions& options) {
  const StereoFiles files = findStereoFiles(path);
  return std::make_unique<StereoSource>(openRecording(files, calibrationOf(files, options)),
                                        address);
}

}  // namespace boomwatch
