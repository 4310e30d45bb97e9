#include "sources/depth_source.h"

#include "base/error.h"
#include "base/size_text.h"
#include "files/bounded_image.h"
#include "sources/depth_recording.h"
#include "sources/indexed_source.h"

namespace boomwatch {
namespace {

void requireSize(const std::filesystem::path& file, cv::Size size, cv::Size wanted) {
  if (size == wanted || wanted.empty()) return;
  throw Error(file.string(), "it is " + sizeText(size) + " pixels, not " + sizeText(wanted),
              "Every image of a recording must have the same size.");
}

cv::Mat readDepth(const std::filesystem::path& file) {
  cv::Mat depth = readImage(file, PixelDepth::AsStored);
  if (depth.type() == CV_16UC1) return depth;
  throw Error(file.string(), "not a depth image: it has no single channel of 16 bits",
              "Write depth as 16-bit grey PNG.");
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
    const DepthCalibration calibration =
        files.intrinsics.empty() ? m_recording.calibration : readDepthCalibration(files.intrinsics);
    auto frame = std::make_shared<Frame>();
    frame->sequence = index;
    frame->stamp = files.stamp;
    if (!files.colour.empty()) {
      frame->left = readImage(files.colour);
      requireSize(files.colour, frame->left.size(), depth.size());
    }
    frame->cloud = std::make_shared<Cloud>(cloudFromDepth(depth, calibration));
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
