#pragma once

#include <filesystem>
#include <opencv2/videoio.hpp>

#include "sources/image_stream.h"

namespace boomwatch {

/// Whether the name ends as that of a video does.
bool hasVideoExtension(const std::filesystem::path& file);

/// A video file as one camera's recording. Picture `index` is the one that decoding from the
/// start gives at that place, whatever the container's own seeking says.
class VideoStream : public ImageStream {
 public:
  /// Throws Error when the file is no video, does not say how many pictures it holds, or holds
  /// pictures too large to take.
  explicit VideoStream(const std::filesystem::path& file);

  std::size_t count() const override { return m_count; }
  std::optional<double> rate() const override { return m_rate; }
  std::optional<cv::Size> size() const override { return m_size; }
  StreamImage read(std::size_t index) override;

 private:
  void open();
  bool skipTo(std::size_t index);
  bool jumpTo(std::size_t index);
  bool decodeTo(std::size_t index);
  bool seeksExactly();

  std::filesystem::path m_file;
  cv::VideoCapture m_video;
  std::size_t m_count = 0;
  std::size_t m_next = 0;  ///< what the next grab gives
  double m_rate = 0.0;
  cv::Size m_size;
  bool m_exact = false;  ///< jumping was seen to land where decoding does
};

}  // namespace boomwatch
