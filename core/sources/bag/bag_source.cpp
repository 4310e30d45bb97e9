#include "sources/bag/bag_source.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/error.h"
#include "base/size_text.h"
#include "sources/bag/bag_choice.h"
#include "sources/bag/bag_cloud.h"
#include "sources/bag/bag_pairs.h"
#include "sources/bag/bag_picture.h"
#include "sources/bag/joined_bag.h"
#include "sources/bag/message_reader.h"
#include "sources/depth_calibration.h"
#include "sources/file_sequence.h"
#include "sources/indexed_source.h"
#include "sources/pinhole_fit.h"
#include "stereo/calibration.h"

namespace boomwatch {
namespace {

constexpr double assumedRate = 10.0;

std::vector<double> secondsOf(const std::vector<BagPair>& pairs) {
  std::vector<double> seconds;
  for (const BagPair& pair : pairs) seconds.push_back(1e-9 * static_cast<double>(pair.stamp));
  return seconds;
}

/// What the three kinds of source have in common: messages by index.
class BagSource : public IndexedSource {
 protected:
  BagSource(const std::string& address, std::unique_ptr<BagFile> bag, BagPairs pairs)
      : IndexedSource(address, pairs.pairs.size(), meanRate(secondsOf(pairs.pairs), assumedRate)),
        m_bag(std::move(bag)),
        m_pairs(std::move(pairs.pairs)) {
    if (!m_bag->damage().empty()) note("Of this bag " + m_bag->damage() + ".");
    if (pairs.unpaired > 0) {
      note(std::to_string(pairs.unpaired) + " pictures have no partner and are left out.");
    }
  }

  ReadResult read(std::size_t index) override {
    auto frame = std::make_shared<Frame>();
    frame->sequence = index;
    frame->stamp = 1e-9 * static_cast<double>(m_pairs[index].stamp);
    std::string fault = fill(m_pairs[index], *frame);
    if (fault.empty()) return ok(std::move(frame));
    return bad(info().address + ", frame " + std::to_string(index + 1) + ": " + fault + ".");
  }

  /// Fills the frame, or says why it cannot be.
  virtual std::string fill(const BagPair& pair, Frame& frame) = 0;

  BagPicture pictureAt(const BagMessage& message) {
    const auto bytes = m_bag->read(message);
    if (!bytes) return {0, {}, "the bag is damaged here; copy it again"};
    return decodePicture(m_bag->topics()[message.topic], *bytes);
  }

  std::unique_ptr<BagFile> m_bag;
  std::vector<BagPair> m_pairs;
};

class StereoBagSource : public BagSource {
 public:
  StereoBagSource(const std::string& address, std::unique_ptr<BagFile> bag, BagPairs pairs,
                  const StereoRig& rig)
      : BagSource(address, std::move(bag), std::move(pairs)),
        m_rig(std::make_shared<StereoRig>(rig)) {}

 protected:
  std::string fill(const BagPair& pair, Frame& frame) override {
    const BagPicture left = pictureAt(pair.first), right = pictureAt(*pair.second);
    if (!left.fault.empty()) return left.fault;
    if (!right.fault.empty()) return right.fault;
    if (left.image.depth() != CV_8U || right.image.depth() != CV_8U) {
      return "a picture has 16 bits; choose topics of 8-bit pictures";
    }
    const cv::Size calibrated = m_rig->imageSize;
    for (const cv::Mat& image : {left.image, right.image}) {
      if (!calibrated.empty() && image.size() != calibrated) {
        return "a picture is " + sizeText(image.size()) + ", but the calibration is for " +
               sizeText(calibrated);
      }
    }
    frame.left = left.image;
    frame.right = right.image;
    frame.rig = m_rig;
    return left.image.size() == right.image.size() ? "" : "left and right differ in size";
  }

 private:
  std::shared_ptr<const StereoRig> m_rig;
};

class DepthBagSource : public BagSource {
 public:
  DepthBagSource(const std::string& address, std::unique_ptr<BagFile> bag, BagPairs pairs,
                 DepthCalibration calibration, cv::Size size)
      : BagSource(address, std::move(bag), std::move(pairs)),
        m_calibration(calibration),
        m_size(size) {}

 protected:
  std::string fill(const BagPair& pair, Frame& frame) override {
    const BagPicture depth = pictureAt(pair.first);
    if (!depth.fault.empty()) return depth.fault;
    if (depth.image.type() != CV_16UC1 && depth.image.type() != CV_32FC1) {
      return "the picture holds no depth; choose another topic";
    }
    if (!m_size.empty() && depth.image.size() != m_size) {
      return "the depth is " + sizeText(depth.image.size()) + ", but its camera_info is for " +
             sizeText(m_size);
    }
    DepthCalibration calibration = m_calibration;
    const cv::Mat metric = depthInMillimetres(depth.image, m_calibration.unitsPerMetre);
    calibration.unitsPerMetre = 1000.0;
    frame.cloud = std::make_shared<Cloud>(cloudFromDepth(metric, calibration));
    if (pair.second) {
      const BagPicture colour = pictureAt(*pair.second);
      if (colour.image.size() == metric.size()) frame.left = colour.image;
    }
    return "";
  }

 private:
  DepthCalibration m_calibration;
  cv::Size m_size;
};

class CloudBagSource : public BagSource {
 public:
  CloudBagSource(const std::string& address, std::unique_ptr<BagFile> bag, BagPairs pairs)
      : BagSource(address, std::move(bag), std::move(pairs)) {
    const BagMessage& first = m_pairs.front().first;
    const auto bytes = m_bag->read(first);
    const std::string frame = bytes ? cloudFrameIn(m_bag->topics()[first.topic], *bytes) : "";
    // ROS calls frames of a camera's own axes so.
    if (frame.find("optical") != std::string::npos) return;
    note(
        "The points are in the frame '" + frame +
        "'. They are taken as x right, y down, z forward of the camera. Record them in its optical "
        "frame if they are not.");
  }

 protected:
  std::string fill(const BagPair& pair, Frame& frame) override {
    const auto bytes = m_bag->read(pair.first);
    if (!bytes) return "the bag is damaged here; copy it again";
    auto cloud = decodeCloud(m_bag->topics()[pair.first.topic], *bytes);
    if (!cloud) return "the cloud is damaged, or has no fields x, y and z";
    if (cloud->organised()) {
      const bool fits =
          m_camera && m_camera->width == cloud->width && m_camera->height == cloud->height;
      if (!fits) m_camera = fitPinhole(*cloud);
      cloud->camera = m_camera;
    }
    frame.cloud = std::make_shared<Cloud>(std::move(*cloud));
    return "";
  }

 private:
  std::optional<PinholeCamera> m_camera;
};

StereoRig rigOf(const BagFile& bag, const BagChoice& choice, const std::string& where,
                const SourceOptions& options) {
  if (!options.calibration.empty()) return readCalibration(options.calibration);
  if (choice.camera && choice.rightCamera) {
    return rigOf(where, *choice.camera, *choice.rightCamera,
                 namesRectified(bag.topics()[choice.first].name));
  }
  throw Error(where, "it has no camera_info for this pair", "Give a file with --calibration.");
}

// RealSense's own recordings: metres a unit, as the first message of std_msgs/Float32.
std::optional<double> realSenseUnit(BagFile& bag) {
  for (const BagMessage& message : bag.messages()) {
    const BagTopic& topic = bag.topics()[message.topic];
    const bool names = topic.name.find("Depth Units/value") != std::string::npos ||
                       topic.name.find("Depth_Units/value") != std::string::npos;
    if (!names || topic.type != "std_msgs/Float32") continue;
    const auto bytes = bag.read(message);
    const float unit = bytes ? MessageReader(*bytes, topic.encoding).number<float>() : 0.0f;
    if (unit > 0.0f && unit < 1.0f) return unit;
  }
  return std::nullopt;
}

DepthCalibration depthCalibrationOf(BagFile& bag, const BagChoice& choice, const std::string& where,
                                    const SourceOptions& options) {
  if (!options.calibration.empty()) return readDepthCalibration(options.calibration);
  if (!choice.camera || !(choice.camera->matrix(0, 0) > 0) || !(choice.camera->matrix(1, 1) > 0)) {
    throw Error(where, "it has no usable camera_info for " + bag.topics()[choice.first].name,
                "Give the depth camera's intrinsics with --calibration.");
  }
  DepthCalibration calibration;
  calibration.camera = pinholeOf(*choice.camera, namesRectified(bag.topics()[choice.first].name));
  calibration.camera.width = calibration.camera.height = 0;
  if (const auto unit = realSenseUnit(bag)) calibration.unitsPerMetre = 1.0 / *unit;
  return calibration;
}

}  // namespace

std::unique_ptr<FrameSource> openBagSource(const std::string& path, const std::string& address,
                                           const SourceOptions& options) {
  if (path.empty()) throw Error(address, "no path is given", "Give bag:FILE.");
  const auto [file, option] = splitBagPath(path);
  auto bag = openBagPath(file);
  const BagChoice choice = chooseTopics(*bag, option, file.string());
  BagPairs pairs = pairMessages(*bag, choice);
  if (pairs.pairs.empty()) {
    throw Error(file.string(), "no left and right picture belong together by their stamps",
                "Choose other topics.");
  }
  switch (choice.kind) {
    case BagKind::Stereo: {
      const StereoRig rig = rigOf(*bag, choice, file.string(), options);
      return std::make_unique<StereoBagSource>(address, std::move(bag), std::move(pairs), rig);
    }
    case BagKind::Depth: {
      const auto calibration = depthCalibrationOf(*bag, choice, file.string(), options);
      const bool own = options.calibration.empty();
      const cv::Size size = own ? choice.camera->size : cv::Size();
      return std::make_unique<DepthBagSource>(address, std::move(bag), std::move(pairs),
                                              calibration, size);
    }
    case BagKind::Cloud:
      break;
  }
  return std::make_unique<CloudBagSource>(address, std::move(bag), std::move(pairs));
}

}  // namespace boomwatch
