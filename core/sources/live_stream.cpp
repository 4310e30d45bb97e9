#include "sources/live_stream.h"

#include <algorithm>

#include "base/error.h"
#include "files/bounded_image.h"

namespace boomwatch {
namespace {

// Without these FFmpeg waits half a minute for a stream that has died.
constexpr int openTimeout = 5000;  // ms
constexpr int readTimeout = 2000;  // ms

bool isNumber(const std::string& text) {
  return !text.empty() && text.size() <= 4 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string withoutPassword(const std::string& device) {
  const auto scheme = device.find("://");
  if (scheme == std::string::npos) return device;
  const auto host = scheme + 3;
  const auto end = std::min(device.find('/', host), device.size());
  const auto at = device.rfind('@', end);
  if (at == std::string::npos || at < host) return device;
  return device.substr(0, host) + "***" + device.substr(at);
}

}  // namespace

bool isDevice(const std::string& text) {
  return isNumber(text) || text.starts_with("/dev/") || text.find("://") != std::string::npos;
}

LiveStream::LiveStream(const std::string& device, Doorbell& doorbell)
    : m_doorbell(doorbell), m_name(withoutPassword(device)) {
  const std::string remedy = "Check that it is connected and that no other program uses it.";
  try {
    open(device);
  } catch (const cv::Exception&) {
    m_capture.release();
  }
  if (!m_capture.isOpened()) throw Error("camera " + m_name, "it cannot be opened", remedy);
  m_rate = std::max(0.0, m_capture.get(cv::CAP_PROP_FPS));
  const double width = m_capture.get(cv::CAP_PROP_FRAME_WIDTH);
  const double height = m_capture.get(cv::CAP_PROP_FRAME_HEIGHT);
  if (width * height > maxImage) {
    throw Error("camera " + m_name, "its pictures are too large", "Choose a smaller format.");
  }
  m_size = {static_cast<int>(width), static_cast<int>(height)};
  m_thread = std::thread([this] { run(); });
}

LiveStream::~LiveStream() {
  m_stop = true;
  m_thread.join();
}

void LiveStream::open(const std::string& device) {
  if (isNumber(device)) {
    m_capture.open(std::stoi(device), cv::CAP_V4L2);
  } else if (device.starts_with("/dev/")) {
    m_capture.open(device, cv::CAP_V4L2);
  } else {
    m_capture.open(
        device, cv::CAP_FFMPEG,
        {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, openTimeout, cv::CAP_PROP_READ_TIMEOUT_MSEC, readTimeout});
  }
}

void LiveStream::discard() {
  slot.reset();
  ++dropped;
}

void LiveStream::run() {
  bool alive = true;
  while (alive && !m_stop) {
    cv::Mat image;
    try {
      alive = m_capture.read(image) && !image.empty();
    } catch (const cv::Exception&) {
      alive = false;
    }
    const auto arrival = std::chrono::steady_clock::now();
    {
      const std::lock_guard lock(m_doorbell.mutex);
      if (alive && slot) ++dropped;
      if (alive) slot = Shot{image, arrival};
      lost = !alive;
    }
    m_doorbell.changed.notify_all();
  }
}

}  // namespace boomwatch
