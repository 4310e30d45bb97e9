#include "sources/video_stream.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "files/bounded_image.h"
#include "files/line_reader.h"

namespace boomwatch {
namespace {

// Decoding this many is quicker than going back to a key picture.
constexpr std::size_t shortHop = 24;
constexpr double maxFrames = 1e9;

}  // namespace

bool hasVideoExtension(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 8> known{".mp4", ".avi",  ".mov", ".m4v",
                                                  ".mkv", ".webm", ".mpg", ".mpeg"};
  return std::ranges::find(known, lowerExtension(file)) != known.end();
}

VideoStream::VideoStream(const std::filesystem::path& file) : m_file(file) {
  // FFmpeg waits for ever at the end of a pipe that nobody writes to.
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault)) {
    throw Error(file.string(), "this is not an ordinary file",
                "Give a video file, or camera:ADDRESS for a stream.");
  }
  open();
  const std::string remedy = "Give a video that FFmpeg can decode, for instance H.264 in MP4.";
  if (!m_video.isOpened()) throw Error(file.string(), "this is not a video", remedy);
  const double frames = m_video.get(cv::CAP_PROP_FRAME_COUNT);
  m_rate = m_video.get(cv::CAP_PROP_FPS);
  const double width = m_video.get(cv::CAP_PROP_FRAME_WIDTH);
  const double height = m_video.get(cv::CAP_PROP_FRAME_HEIGHT);
  if (!(frames >= 1 && frames <= maxFrames) || !(m_rate > 0 && m_rate <= 1e4)) {
    throw Error(file.string(), "the video does not say how many frames it has and how fast",
                "Copy it into a container that does: ffmpeg -i IN -c copy OUT.mp4");
  }
  if (!(width >= 1 && height >= 1 && width * height <= maxImage)) {
    throw Error(file.string(), "its pictures are too large or have no size", remedy);
  }
  m_count = static_cast<std::size_t>(frames);
  m_size = {static_cast<int>(width), static_cast<int>(height)};
  if (!m_video.grab()) throw Error(file.string(), "not one frame can be decoded", remedy);
  m_next = 1;
  m_exact = seeksExactly();
  if (!m_exact) open();
}

void VideoStream::open() {
  m_next = 0;
  try {
    m_video.open(m_file.string(), cv::CAP_FFMPEG);
    // A calibration belongs to pixels as stored.
    if (m_video.isOpened()) m_video.set(cv::CAP_PROP_ORIENTATION_AUTO, 0);
  } catch (const cv::Exception&) {
    m_video.release();
  }
}

// FFmpeg seeks by time. That gives the frame that counting gives only where frames come at even
// intervals: then the last one, in a container that counts its frames, is at its even time.
bool VideoStream::seeksExactly() {
  const auto extension = m_file.extension();
  if (extension != ".mp4" && extension != ".mov" && extension != ".avi") return false;
  return m_count > 2 * shortHop && jumpTo(m_count - 1) && m_video.grab() &&
         std::abs(m_video.get(cv::CAP_PROP_POS_MSEC) * m_rate / 1000 -
                  static_cast<double>(m_count - 1)) < 0.5 &&
         (++m_next, !m_video.grab());
}

bool VideoStream::jumpTo(std::size_t index) {
  m_video.set(cv::CAP_PROP_POS_FRAMES, static_cast<double>(index));
  const bool landed = m_video.get(cv::CAP_PROP_POS_FRAMES) == static_cast<double>(index);
  m_next = landed ? index : m_count + 1;  // lost: decoding begins anew
  return landed;
}

bool VideoStream::decodeTo(std::size_t index) {
  if (index < m_next) open();
  for (; m_next < index; ++m_next) {
    if (!m_video.grab()) return false;
  }
  return true;
}

bool VideoStream::skipTo(std::size_t index) {
  const bool near = index >= m_next && index - m_next <= shortHop;
  if (!near && m_exact && jumpTo(index)) return true;
  return decodeTo(index);
}

StreamImage VideoStream::read(std::size_t index) {
  try {
    cv::Mat image;
    if (skipTo(index) && m_video.grab() && (++m_next, m_video.retrieve(image)) && !image.empty() &&
        image.depth() == CV_8U) {
      return {image, "", false};
    }
  } catch (const cv::Exception&) {
    // Treated as the end: a decoder that failed gives nothing more.
  }
  return {{}, m_file.string() + ": the video ends before frame " + std::to_string(index + 1), true};
}

}  // namespace boomwatch
