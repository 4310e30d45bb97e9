#include "sources/bag/bag_camera.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/size_text.h"
#include "sources/bag/message_reader.h"

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
  if (p1(0, 0) <= 0 || p2(0, 0) <= 0) {
    throw Error(where, "the camera_info of this pair has no projection matrix P",
                "Calibrate the pair, and give the file with --calibration.");
  }
  if (left.size != right.size) {
    throw Error(where,
                "the left camera_info is for " + sizeText(left.size) + ", the right one for " +
                    sizeText(right.size),
                "Choose two topics of one pair.");
  }
  for (const BagCamera* camera : {&left, &right}) {
    const std::string& model = camera->model;
    if (rectified || model.empty() || model == "plumb_bob" || model == "rational_polynomial")
      continue;
    throw Error(where, "the lens model '" + model + "' is not read", "Record rectified pictures.");
  }
  const double shift = (p2(0, 3) - p1(0, 3)) / p2(0, 0);
  constexpr double maxBaseline = 1.0;
  if (!(shift < 0) || !(shift > -maxBaseline)) {
    throw Error(where, "the camera_info gives a baseline of " + std::to_string(-shift) + " m",
                "Left and right are swapped where it is negative: give bag:FILE,left=...,right=... "
                "Otherwise P must be in metres.");
  }
  StereoRig rig;
  rig.imageSize = left.size;
  rig.rectified = rectified;
  if (rectified) {
    rig.leftMatrix = p1.get_minor<3, 3>(0, 0);
    rig.rightMatrix = p2.get_minor<3, 3>(0, 0);
    rig.translation = {shift, 0, 0};
    return rig;
  }
  rig.leftMatrix = left.matrix;
  rig.rightMatrix = right.matrix;
  rig.leftDistortion = cv::Mat(left.distortion, true).reshape(1, 1);
  rig.rightDistortion = cv::Mat(right.distortion, true).reshape(1, 1);
  // Rectified rays: R1 left + t = R2 right.
  rig.rotation = right.rectification.t() * left.rectification;
  rig.translation = right.rectification.t() * cv::Vec3d(shift, 0, 0);
  return rig;
}

}  // namespace boomwatch
