#include "sources/bag/bag_camera.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/size_text.h"
#include "sources/bag/message_reader.h"
#include "stereo/calibration.h"

namespace boomwatch {
namespace {

using Json = nlohmann::json;

// The longest camera model has 14 coefficients; more is damage.
constexpr std::size_t maxCoefficients = 64;

std::vector<double> numbersIn(const Json& message, const char* key) {
  return message.at(key).get<std::vector<double>>();
}

std::optional<BagCamera> cameraFrom(std::uint32_t width, std::uint32_t height, std::string model,
                                    std::vector<double> d, const std::vector<double>& k,
                                    const std::vector<double>& r, const std::vector<double>& p) {
  constexpr std::uint32_t maxSide = 65535;
  const bool whole = k.size() == 9 && (r.empty() || r.size() == 9) && p.size() == 12 &&
                     d.size() <= maxCoefficients && width <= maxSide && height <= maxSide;
  if (!whole) return std::nullopt;
  BagCamera camera;
  camera.size = cv::Size(int(width), int(height));
  camera.model = std::move(model);
  camera.distortion = std::move(d);
  camera.matrix = cv::Matx33d(k.data());
  camera.rectification = r.empty() ? cv::Matx33d::eye() : cv::Matx33d(r.data());
  camera.projection = cv::Matx34d(p.data());
  return camera;
}

std::optional<BagCamera> decodeJson(std::string_view bytes) {
  const Json message = Json::parse(bytes);
  return cameraFrom(message.at("width").get<std::uint32_t>(),
                    message.at("height").get<std::uint32_t>(),
                    message.at("distortion_model").get<std::string>(), numbersIn(message, "D"),
                    numbersIn(message, "K"), numbersIn(message, "R"), numbersIn(message, "P"));
}

// Another lens' coefficients would be taken for what they are not.
void requirePinhole(const std::string& where, const BagCamera& camera) {
  const std::string& model = camera.model;
  if (model.empty() || model == "plumb_bob" || model == "rational_polynomial") return;
  throw Error(where, "the lens model '" + model + "' is not read",
              "Record rectified pictures, of plumb_bob or rational_polynomial cameras.");
}

// One row; empty where no coefficient is set.
cv::Mat rowOf(const std::vector<double>& coefficients) {
  const bool bends = std::ranges::any_of(coefficients, [](double c) { return c != 0.0; });
  return bends ? cv::Mat(coefficients, true).reshape(1, 1) : cv::Mat();
}

}  // namespace

bool isCameraType(std::string_view type) {
  return type == "sensor_msgs/CameraInfo" || type == "foxglove.CameraCalibration";
}

std::optional<BagCamera> decodeCamera(const BagTopic& topic, std::string_view bytes) {
  if (topic.encoding == BagEncoding::Json) {
    try {
      return decodeJson(bytes);
    } catch (const Json::exception&) {
      return std::nullopt;
    }
  }
  MessageReader reader(bytes, topic.encoding);
  reader.header();
  const auto height = reader.number<std::uint32_t>();
  const auto width = reader.number<std::uint32_t>();
  std::string model = reader.text();
  std::vector<double> d = reader.doubles();
  const auto k = reader.doubles(9), r = reader.doubles(9), p = reader.doubles(12);
  if (reader.failed()) return std::nullopt;
  return cameraFrom(width, height, std::move(model), std::move(d), k, r, p);
}

PinholeCamera pinholeOf(const BagCamera& camera, bool rectified) {
  const bool byProjection = rectified && camera.projection(0, 0) > 0;
  const cv::Matx33d m = byProjection ? camera.projection.get_minor<3, 3>(0, 0) : camera.matrix;
  PinholeCamera pinhole;
  pinhole.fx = m(0, 0);
  pinhole.fy = m(1, 1);
  pinhole.cx = m(0, 2);
  pinhole.cy = m(1, 2);
  pinhole.width = camera.size.width;
  pinhole.height = camera.size.height;
  return pinhole;
}

StereoRig rigOf(const std::string& where, const BagCamera& left, const BagCamera& right,
                bool rectified) {
  const cv::Matx34d &p1 = left.projection, &p2 = right.projection;
  if (!(p1(0, 0) > 0) || !(p2(0, 0) > 0)) {
    throw Error(where, "the camera_info of this pair has no projection matrix P",
                "Calibrate the pair, and give the file with --calibration.");
  }
  if (left.size != right.size) {
    throw Error(where,
                "the left camera_info is for " + sizeText(left.size) + ", the right one for " +
                    sizeText(right.size),
                "Choose two topics of one pair.");
  }
  StereoRig rig;
  rig.imageSize = left.size;
  rig.rectified = rectified;
  const cv::Vec3d shift((p2(0, 3) - p1(0, 3)) / p2(0, 0), 0, 0);
  if (rectified) {
    rig.leftMatrix = p1.get_minor<3, 3>(0, 0);
    rig.rightMatrix = p2.get_minor<3, 3>(0, 0);
    rig.translation = shift;
  } else {
    requirePinhole(where, left);
    requirePinhole(where, right);
    rig.leftMatrix = left.matrix;
    rig.rightMatrix = right.matrix;
    rig.leftDistortion = rowOf(left.distortion);
    rig.rightDistortion = rowOf(right.distortion);
    // Rectified rays: R1 left + t = R2 right.
    rig.rotation = right.rectification.t() * left.rectification;
    rig.translation = right.rectification.t() * shift;
  }
  checkRig(where, rig);
  constexpr double usual = 1.0;
  if (rig.baseline() > usual) {
    throw Error(where,
                "the camera_info gives a baseline of " + std::to_string(rig.baseline()) + " m",
                "P must be in metres. If the cameras are that far apart, give a calibration file "
                "with --calibration.");
  }
  return rig;
}

}  // namespace boomwatch
