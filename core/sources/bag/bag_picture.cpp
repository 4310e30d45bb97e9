#include "sources/bag/bag_picture.h"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "files/bounded_image.h"
#include "sources/bag/base64.h"
#include "sources/bag/message_reader.h"

namespace boomwatch {
namespace {

using Json = nlohmann::json;

struct Format {
  std::string_view name;
  int type;        // of the bytes
  int conversion;  // to BGR or grey; -1: none
};

// ROS names Bayer patterns by their first two pixels, OpenCV by the second row's second and third.
constexpr Format formats[] = {
    {"mono8", CV_8UC1, -1},
    {"8UC1", CV_8UC1, -1},
    {"bgr8", CV_8UC3, -1},
    {"8UC3", CV_8UC3, -1},
    {"rgb8", CV_8UC3, cv::COLOR_RGB2BGR},
    {"bgra8", CV_8UC4, cv::COLOR_BGRA2BGR},
    {"8UC4", CV_8UC4, cv::COLOR_BGRA2BGR},
    {"rgba8", CV_8UC4, cv::COLOR_RGBA2BGR},
    {"bayer_rggb8", CV_8UC1, cv::COLOR_BayerBG2BGR},
    {"bayer_bggr8", CV_8UC1, cv::COLOR_BayerRG2BGR},
    {"bayer_gbrg8", CV_8UC1, cv::COLOR_BayerGR2BGR},
    {"bayer_grbg8", CV_8UC1, cv::COLOR_BayerGB2BGR},
    {"yuv422", CV_8UC2, cv::COLOR_YUV2BGR_UYVY},
    {"uyvy", CV_8UC2, cv::COLOR_YUV2BGR_UYVY},
    {"yuv422_yuy2", CV_8UC2, cv::COLOR_YUV2BGR_YUY2},
    {"yuyv", CV_8UC2, cv::COLOR_YUV2BGR_YUY2},
    {"mono16", CV_16UC1, -1},
    {"16UC1", CV_16UC1, -1},
    {"32FC1", CV_32FC1, -1},
};

struct RawPicture {
  std::uint32_t width = 0, height = 0, step = 0;
  std::string encoding;
  bool isBigEndian = false;
  std::string_view data;
};

void decodeRaw(const RawPicture& raw, BagPicture& result) {
  const auto* format = std::ranges::find(formats, raw.encoding, &Format::name);
  if (format == std::end(formats)) {
    result.fault = "pictures of the encoding '" + raw.encoding + "' are not read";
    return;
  }
  const std::uint64_t row = std::uint64_t(raw.width) * CV_ELEM_SIZE(format->type);
  const bool fits = raw.width > 0 && raw.height > 0 &&
                    double(raw.width) * double(raw.height) <= maxImage && raw.step >= row &&
                    raw.data.size() >= std::uint64_t(raw.step) * (raw.height - 1) + row;
  if (!fits) {
    result.fault = "the picture is shorter than its size says";
    return;
  }
  if (raw.isBigEndian && CV_ELEM_SIZE1(format->type) > 1) {
    result.fault = "big-endian pictures are not read";
    return;
  }
  // Only read, and copied or converted before the bytes go.
  const cv::Mat view(int(raw.height), int(raw.width), format->type,
                     const_cast<char*>(raw.data.data()), raw.step);
  if (format->conversion < 0) {
    result.image = view.clone();
  } else if (format->type == CV_8UC2 && raw.width % 2 != 0) {
    result.fault = "a yuv422 picture has an odd width";
  } else {
    cv::cvtColor(view, result.image, format->conversion);
  }
}

// compressed_depth_image_transport: what PNG holds of 32-bit depth is a quantised inverse.
void decodeCompressedDepth(std::string_view format, std::string_view data, BagPicture& result) {
  constexpr std::size_t head = 12;
  if (format.find("rvl") != std::string_view::npos || data.size() < head) {
    result.fault = "compressed depth is read as PNG only";
    return;
  }
  std::array<float, 3> numbers{};
  std::memcpy(numbers.data(), data.data(), head);
  const cv::Mat packed = decodeImage(data.substr(head), PixelDepth::AsStored);
  if (packed.type() != CV_16UC1) {
    result.fault = "the compressed depth is damaged";
    return;
  }
  if (!format.starts_with("32FC1")) {
    result.image = packed;
    return;
  }
  const float a = numbers[1], b = numbers[2];
  result.image = cv::Mat(packed.size(), CV_32FC1);
  for (int y = 0; y < packed.rows; ++y) {
    for (int x = 0; x < packed.cols; ++x) {
      const auto value = packed.at<std::uint16_t>(y, x);
      result.image.at<float>(y, x) =
          value == 0 ? std::numeric_limits<float>::quiet_NaN() : a / (float(value) - b);
    }
  }
}

void decodePacked(const std::string& format, std::string_view data, BagPicture& result) {
  if (format.find("compressedDepth") != std::string::npos) {
    decodeCompressedDepth(format, data, result);
    return;
  }
  result.image = decodeImage(data, PixelDepth::AsStored);
  if (result.image.type() == CV_8UC4) {
    cv::cvtColor(result.image, result.image, cv::COLOR_BGRA2BGR);
  }
  const int type = result.image.type();
  const bool known = type == CV_8UC1 || type == CV_8UC3 || type == CV_16UC1;
  if (result.image.empty() || !known) {
    result.image.release();
    result.fault = "the packed picture (" + format + ") is damaged, or neither PNG nor JPEG";
  }
}

void decodeRos(const BagTopic& topic, std::string_view bytes, BagPicture& result) {
  MessageReader reader(bytes, topic.encoding);
  result.stamp = reader.header().stamp;
  if (topic.type == "sensor_msgs/CompressedImage") {
    const std::string format = reader.text();
    const std::string_view data = reader.bytes();
    if (!reader.failed()) return decodePacked(format, data, result);
  } else {
    RawPicture raw;
    raw.height = reader.number<std::uint32_t>();
    raw.width = reader.number<std::uint32_t>();
    raw.encoding = reader.text();
    raw.isBigEndian = reader.number<std::uint8_t>() != 0;
    raw.step = reader.number<std::uint32_t>();
    raw.data = reader.bytes();
    if (!reader.failed()) return decodeRaw(raw, result);
  }
  result.fault = "the message is cut";
}

std::int64_t jsonStamp(const Json& message) {
  const Json& stamp = message.at("timestamp");
  const std::int64_t nanoseconds = stamp.at("nsec").get<std::uint32_t>();
  return std::int64_t(stamp.at("sec").get<std::uint32_t>()) * 1'000'000'000 + nanoseconds;
}

void decodeJson(const BagTopic& topic, std::string_view bytes, BagPicture& result) {
  const Json message = Json::parse(bytes);
  result.stamp = jsonStamp(message);
  const std::string data = bytesOfBase64(message.at("data").get_ref<const std::string&>());
  if (topic.type == "foxglove.CompressedImage") {
    return decodePacked(message.at("format").get<std::string>(), data, result);
  }
  RawPicture raw;
  raw.width = message.at("width").get<std::uint32_t>();
  raw.height = message.at("height").get<std::uint32_t>();
  raw.step = message.at("step").get<std::uint32_t>();
  raw.encoding = message.at("encoding").get<std::string>();
  raw.data = data;
  decodeRaw(raw, result);
}

}  // namespace

bool isPictureType(std::string_view type) {
  return type == "sensor_msgs/Image" || type == "sensor_msgs/CompressedImage" ||
         type == "foxglove.RawImage" || type == "foxglove.CompressedImage";
}

BagPicture decodePicture(const BagTopic& topic, std::string_view bytes) {
  BagPicture result;
  try {
    if (topic.encoding == BagEncoding::Json) {
      decodeJson(topic, bytes, result);
    } else {
      decodeRos(topic, bytes, result);
    }
  } catch (const std::exception&) {  // of the JSON parser, or of OpenCV
    result.image.release();
    result.fault = "the message is damaged";
  }
  return result;
}

std::int64_t stampIn(const BagTopic& topic, std::string_view bytes) {
  if (topic.encoding != BagEncoding::Json) {
    MessageReader reader(bytes, topic.encoding);
    const std::int64_t stamp = reader.header().stamp;
    return reader.failed() ? 0 : stamp;
  }
  const Json message = Json::parse(bytes, nullptr, false);
  try {
    return message.is_object() ? jsonStamp(message) : 0;
  } catch (const Json::exception&) {
    return 0;
  }
}

cv::Mat depthInMillimetres(const cv::Mat& depth, double unitsPerMetre) {
  const double scale = depth.type() == CV_32FC1 ? 1000.0 : 1000.0 / unitsPerMetre;
  cv::Mat metric(depth.size(), CV_16UC1, cv::Scalar(0));
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const double value = scale * (depth.type() == CV_32FC1 ? double(depth.at<float>(y, x))
                                                             : depth.at<std::uint16_t>(y, x));
      if (value > 0.0 && value < 65535.0) {
        metric.at<std::uint16_t>(y, x) = static_cast<std::uint16_t>(std::lround(value));
      }
    }
  }
  return metric;
}

}  // namespace boomwatch
