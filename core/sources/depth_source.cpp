#include "sources/depth_source.h"

#include <opencv2/imgproc.hpp>

#include "frame/error.h"
#include "sources/depth_layout.h"
#include "sources/image_bytes.h"
#include "sources/indexed_source.h"

namespace boomwatch {
namespace {

std::string text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

void requireSize(const std::filesystem::path& file, cv::Size size, cv::Size wanted) {
  if (size == wanted || wanted.empty()) return;
  throw Error(file.string(), "it is " + text(size) + " pixels, not " + text(wanted),
              "Every image of a recording must have the same size.");
}

cv::Mat readDepth(const std::filesystem::path& file) {
  cv::Mat depth = readImageFile(file);
  if (depth.type() == CV_16UC1) return depth;
  throw Error(file.string(), "not a depth image: it has no single channel of 16 bits",
              "Write depth as 16-bit grey PNG.");
}

/// 8-bit, one channel or BGR, whatever the file holds.
cv::Mat readColour(const std::filesystem::path& file) {
  cv::Mat image = readImageFile(file);
  if (image.channels() == 4) cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
  if (image.depth() == CV_16U) image.convertTo(image, CV_8U, 1.0 / 257.0);
  if (image.type() == CV_8UC1 || image.type() == CV_8UC3) return image;
  throw Error(file.string(), "not a grey or colour image", "Write it as 8-bit PNG or JPEG.");
}

class DepthSource : public IndexedSource {
 public:
  DepthSource(const std::string& address, DepthRecording recording)
      : IndexedSource(address, recording.frames.size(), recording.rate),
        m_recording(std::move(recording)) {}

 protected:
  ReadResult read(std::size_t index) override {
    try {
      return ok(readFrame(index));
    } catch (const Error& error) {
      return bad(error.what());
    }
  }

 private:
  FramePtr readFrame(std::size_t index) {
    const DepthFrameFiles& files = m_recording.frames[index];
    const cv::Mat depth = readDepth(files.depth);
    requireSize(files.depth, depth.size(), m_size);
    const DepthCamera camera =
        files.intrinsics.empty() ? m_recording.camera : readDepthCamera(files.intrinsics);
    auto frame = std::make_shared<Frame>();
    frame->sequence = index;
    frame->stamp = files.stamp;
    if (!files.colour.empty()) {
      frame->left = readColour(files.colour);
      requireSize(files.colour, frame->left.size(), depth.size());
    }
    frame->cloud = std::make_shared<Cloud>(cloudFromDepth(depth, camera));
    m_size = depth.size();
    return frame;
  }

  DepthRecording m_recording;
  cv::Size m_size;  ///< of the first frame that could be read
};

}  // namespace

std::unique_ptr<FrameSource> openDepthSource(const std::filesystem::path& path,
                                             const std::string& address) {
  if (path.empty()) throw Error(address, "no path is given", "Give depth:FOLDER.");
  return std::make_unique<DepthSource>(address, findDepthRecording(path));
}

}  // namespace boomwatch
