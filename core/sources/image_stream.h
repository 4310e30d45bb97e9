#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

namespace boomwatch {

/// One picture of a recording, or why there is none.
struct StreamImage {
  cv::Mat image;      ///< CV_8UC1 or CV_8UC3 (BGR); empty when there is none
  std::string fault;  ///< why this picture could not be read
  bool end = false;   ///< the recording is over, earlier than it promised
};

/// One camera's recording: pictures by index. Used by one thread.
class ImageStream {
 public:
  virtual ~ImageStream() = default;
  virtual std::size_t count() const = 0;
  /// Pictures a second; absent where the recording does not say.
  virtual std::optional<double> rate() const = 0;
  /// Of the first picture; absent where it cannot be told.
  virtual std::optional<cv::Size> size() const = 0;
  /// Any index below count(); reading on in order is fastest. Never throws.
  virtual StreamImage read(std::size_t index) = 0;
};

}  // namespace boomwatch
