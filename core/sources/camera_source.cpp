#include "sources/camera_source.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/size_text.h"
#include "sources/live_stream.h"
#include "stereo/calibration.h"

namespace boomwatch {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// A load that swings at 1 m/s moves 4 cm, one default cell, in this time.
constexpr Seconds maxSkew{0.04};

// An address may itself hold commas, so both sides of one must look like devices.
std::vector<std::string> splitDevices(const std::string& devices) {
  for (auto comma = devices.find(','); comma != std::string::npos;
       comma = devices.find(',', comma + 1)) {
    const std::string left = devices.substr(0, comma), right = devices.substr(comma + 1);
    if (isDevice(left) && isDevice(right)) return {left, right};
  }
  if (isDevice(devices)) return {devices};
  throw Error("camera:" + devices, "this does not name a camera",
              "Give camera:LEFT,RIGHT or camera:ONE (side by side); each a device number or a "
              "stream's address such as rtsp://host/path.");
}

StereoRig calibrationOf(const std::string& devices, const SourceOptions& options) {
  if (!options.calibration.empty()) return readCalibration(options.calibration);
  throw Error("camera:" + devices, "live cameras need a calibration",
              "Name its file with --calibration.");
}

class CameraSource : public FrameSource {
 public:
  CameraSource(const std::vector<std::string>& devices, std::string address, const StereoRig& rig)
      : m_rig(std::make_shared<StereoRig>(rig)) {
    for (const auto& device : devices) {
      m_streams.push_back(std::make_unique<LiveStream>(device, m_doorbell));
      checkSize(*m_streams.back(), devices.size() == 1);
    }
    m_info = {std::move(address), std::nullopt, m_streams.front()->rate(), true};
  }

  SourceInfo info() const override { return m_info; }
  bool seek(std::size_t) override { return false; }

  ReadResult next(std::chrono::milliseconds patience) override {
    const auto deadline = Clock::now() + patience;
    std::unique_lock lock(m_doorbell.mutex);
    while (!pairIsReady()) {
      if (const auto* gone = lostStream()) {
        return {ReadResult::Status::Lost, nullptr, "camera " + gone->name() + " is gone",
                dropped()};
      }
      if (m_doorbell.changed.wait_until(lock, deadline) == std::cv_status::timeout &&
          !pairIsReady()) {
        return {ReadResult::Status::Stalled, nullptr, whatIsMissing(), dropped()};
      }
    }
    std::vector<Shot> shots;
    for (auto& stream : m_streams) {
      shots.push_back(std::move(*stream->slot));
      stream->slot.reset();
    }
    const std::size_t missed = dropped();
    lock.unlock();
    return deliver(shots, missed);
  }

 private:
  void checkSize(const LiveStream& stream, bool sideBySide) const {
    cv::Size size = stream.size();
    if (sideBySide) size.width /= 2;
    if (size.empty() || m_rig->imageSize.empty() || size == m_rig->imageSize) return;
    throw Error("camera " + stream.name(),
                "its pictures are " + sizeText(size) + ", but the calibration is for " +
                    sizeText(m_rig->imageSize),
                "Give the calibration of these cameras at this size.");
  }

  // The following five need the doorbell's mutex.
  bool pairIsReady() {
    if (!std::all_of(m_streams.begin(), m_streams.end(), [](auto& s) { return bool(s->slot); })) {
      return false;
    }
    if (m_streams.size() == 1 || skew() <= maxSkew) return true;
    // The partner of the older one did not come; the newer one's may.
    const bool leftIsOlder = m_streams[0]->slot->arrival < m_streams[1]->slot->arrival;
    m_streams[leftIsOlder ? 0 : 1]->discard();
    return false;
  }

  Seconds skew() const {
    const Seconds apart = m_streams[0]->slot->arrival - m_streams[1]->slot->arrival;
    return apart < Seconds::zero() ? -apart : apart;
  }

  const LiveStream* lostStream() const {
    for (const auto& stream : m_streams) {
      if (stream->lost) return stream.get();
    }
    return nullptr;
  }

  std::string whatIsMissing() const {
    for (const auto& stream : m_streams) {
      if (!stream->slot) return "nothing comes from camera " + stream->name();
    }
    return "left and right come too far apart in time";
  }

  std::size_t dropped() {
    std::size_t most = 0;
    for (auto& stream : m_streams) most = std::max(most, std::exchange(stream->dropped, 0));
    return most;
  }

  ReadResult deliver(const std::vector<Shot>& shots, std::size_t missed) {
    auto frame = std::make_shared<Frame>();
    frame->sequence = m_sequence++;
    frame->stamp = Seconds(shots.front().arrival - m_opened).count();
    frame->rig = m_rig;
    if (shots.size() == 2) {
      frame->left = shots[0].image;
      frame->right = shots[1].image;
    } else {
      const cv::Mat& both = shots.front().image;
      const int middle = both.cols / 2;
      frame->left = both.colRange(0, middle).clone();
      frame->right = both.colRange(middle, both.cols).clone();
    }
    const std::string fault = faultOf(*frame);
    if (!fault.empty()) return {ReadResult::Status::Bad, nullptr, fault, missed};
    return {ReadResult::Status::Ok, frame, note(shots), missed};
  }

  std::string faultOf(const Frame& frame) const {
    for (const cv::Mat* image : {&frame.left, &frame.right}) {
      if (image->type() != CV_8UC1 && image->type() != CV_8UC3) {
        return "a camera gives pictures that are neither grey nor colour";
      }
    }
    const cv::Size size = frame.left.size();
    if (size != frame.right.size()) {
      return "left is " + sizeText(size) + " and right is " + sizeText(frame.right.size());
    }
    if (m_rig->imageSize.empty() || size == m_rig->imageSize) return "";
    return "the pictures are " + sizeText(size) + ", but the calibration is for " +
           sizeText(m_rig->imageSize);
  }

  static std::string note(const std::vector<Shot>& shots) {
    if (shots.size() == 1) return "";
    const double apart = std::abs(Seconds(shots[0].arrival - shots[1].arrival).count());
    return "left and right came " + std::to_string(std::lround(apart * 1000)) + " ms apart";
  }

  std::shared_ptr<const StereoRig> m_rig;
  Clock::time_point m_opened = Clock::now();
  std::uint64_t m_sequence = 0;
  SourceInfo m_info;
  Doorbell m_doorbell;
  std::vector<std::unique_ptr<LiveStream>> m_streams;  ///< last: their threads use the doorbell
};

}  // namespace

std::unique_ptr<FrameSource> openCameraSource(const std::string& devices,
                                              const std::string& address,
                                              const SourceOptions& options) {
  const auto names = splitDevices(devices);
  return std::make_unique<CameraSource>(names, address, calibrationOf(devices, options));
}

}  // namespace boomwatch
