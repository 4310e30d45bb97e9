#include "sources/bag/bag_cloud.h"

#include <array>
#include <cstring>

#include "files/bounded_image.h"
#include "sources/bag/message_reader.h"

namespace boomwatch {
namespace {

// PointField's numbers for its types.
constexpr std::uint8_t float32 = 7, float64 = 8;

struct Field {
  std::uint32_t offset = 0;
  std::uint8_t type = 0;

  std::uint32_t size() const { return type == float64 ? 8 : 4; }
  float at(const char* point) const {
    if (type == float64) {
      double value = 0;
      std::memcpy(&value, point + offset, sizeof(value));
      return static_cast<float>(value);
    }
    float value = 0;
    std::memcpy(&value, point + offset, sizeof(value));
    return value;
  }
};

struct Layout {
  std::uint32_t width = 0, height = 0, pointStep = 0, rowStep = 0;
  std::array<Field, 3> axes;
  bool isBigEndian = false;
  std::string_view data;

  bool isWhole() const {
    bool fits = !isBigEndian && width > 0 && height > 0 &&
                double(width) * double(height) <= maxImage &&
                rowStep >= std::uint64_t(width) * pointStep &&
                data.size() >= std::uint64_t(rowStep) * height;
    for (const Field& axis : axes) {
      fits = fits && (axis.type == float32 || axis.type == float64) &&
             std::uint64_t(axis.offset) + axis.size() <= pointStep;
    }
    return fits;
  }
};

Layout layoutOf(MessageReader& reader) {
  Layout layout;
  reader.header();
  layout.height = reader.number<std::uint32_t>();
  layout.width = reader.number<std::uint32_t>();
  const auto fields = reader.number<std::uint32_t>();
  for (std::uint32_t k = 0; k < fields && !reader.failed(); ++k) {
    const std::string name = reader.text();
    Field field;
    field.offset = reader.number<std::uint32_t>();
    field.type = reader.number<std::uint8_t>();
    reader.number<std::uint32_t>();  // how many of them
    if (name == "x") layout.axes[0] = field;
    if (name == "y") layout.axes[1] = field;
    if (name == "z") layout.axes[2] = field;
  }
  layout.isBigEndian = reader.number<std::uint8_t>() != 0;
  layout.pointStep = reader.number<std::uint32_t>();
  layout.rowStep = reader.number<std::uint32_t>();
  layout.data = reader.bytes();
  return layout;
}

}  // namespace

std::string cloudFrameIn(const BagTopic& topic, std::string_view bytes) {
  return MessageReader(bytes, topic.encoding).header().frame;
}

std::optional<Cloud> decodeCloud(const BagTopic& topic, std::string_view bytes) {
  MessageReader reader(bytes, topic.encoding);
  const Layout layout = layoutOf(reader);
  if (reader.failed() || !layout.isWhole()) return std::nullopt;
  Cloud cloud;
  cloud.width = int(layout.width);
  cloud.height = int(layout.height);
  cloud.points.reserve(std::size_t(layout.width) * layout.height);
  for (std::uint32_t row = 0; row < layout.height; ++row) {
    const char* point = layout.data.data() + std::size_t(row) * layout.rowStep;
    for (std::uint32_t column = 0; column < layout.width; ++column, point += layout.pointStep) {
      const Eigen::Vector3f p(layout.axes[0].at(point), layout.axes[1].at(point),
                              layout.axes[2].at(point));
      cloud.points.push_back(isMeasured(p) ? p : unmeasuredPoint());
    }
  }
  return cloud;
}

}  // namespace boomwatch
