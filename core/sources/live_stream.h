#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string>
#include <thread>

namespace boomwatch {

/// What the threads of a source's streams and its reader share.
struct Doorbell {
  std::mutex mutex;
  std::condition_variable changed;
};

/// One picture as it came from a camera.
struct Shot {
  cv::Mat image;
  std::chrono::steady_clock::time_point arrival;
};

/// One camera or network stream, read on a thread of its own into one slot: the latest wins.
class LiveStream {
 public:
  /// `device`: a number, a path below /dev, or an address with "://". Blocks until it is open,
  /// a few seconds at most. Throws Error when it cannot be opened.
  LiveStream(const std::string& device, Doorbell& doorbell);
  /// Waits for a read that is under way: a few seconds at most, when the stream has gone silent.
  ~LiveStream();

  const std::string& name() const { return m_name; }  ///< the device, without its password
  double rate() const { return m_rate; }              ///< frames a second; 0 if it does not say
  cv::Size size() const { return m_size; }            ///< empty if it does not say

  /// The following are to be used while the doorbell's mutex is held.
  std::optional<Shot> slot;
  std::size_t dropped = 0;  ///< shots that nobody took
  bool lost = false;

  /// Empties the slot, its shot unused.
  void discard();

 private:
  void open(const std::string& device);
  void run();

  Doorbell& m_doorbell;
  std::string m_name;
  cv::VideoCapture m_capture;
  double m_rate = 0.0;
  cv::Size m_size;
  std::atomic<bool> m_stop = false;
  std::thread m_thread;
};

/// Whether `text` can name a camera or stream.
bool isDevice(const std::string& text);

}  // namespace boomwatch
