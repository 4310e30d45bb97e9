#include "sources/point_table.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "files/line_reader.h"

namespace boomwatch {
namespace {

template <class T>
T load(const char* at, bool bigEndian) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if (bigEndian != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

double loadScalar(const PointField& field, const char* at, bool bigEndian) {
  if (field.kind == ScalarKind::Float) {
    return field.size == 4 ? load<float>(at, bigEndian) : load<double>(at, bigEndian);
  }
  const bool isSigned = field.kind == ScalarKind::Signed;
  switch (field.size) {
    case 1:
      return isSigned ? load<std::int8_t>(at, bigEndian) : load<std::uint8_t>(at, bigEndian);
    case 2:
      return isSigned ? load<std::int16_t>(at, bigEndian) : load<std::uint16_t>(at, bigEndian);
    case 4:
      return isSigned ? load<std::int32_t>(at, bigEndian) : load<std::uint32_t>(at, bigEndian);
    default:
      return isSigned ? static_cast<double>(load<std::int64_t>(at, bigEndian))
                      : static_cast<double>(load<std::uint64_t>(at, bigEndian));
  }
}

float toFloat(double value) {
  const bool fits = std::abs(value) <= std::numeric_limits<float>::max();
  return fits ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
}

/// Writes the low bytes of a whole number, if the type of `size` bytes can hold it.
template <class T>
bool storeInteger(std::string_view text, std::size_t size, char* to) {
  const auto value = toNumber<T>(text);
  if (!value) return false;
  if (size < sizeof(T)) {
    constexpr bool isSigned = std::is_signed_v<T>;
    const T beyond = *value >> (size * 8 - (isSigned ? 1 : 0));
    if (beyond != 0 && !(isSigned && beyond == static_cast<T>(-1))) return false;
  }
  const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(*value);
  const std::size_t first = std::endian::native == std::endian::big ? sizeof(T) - size : 0;
  std::memcpy(to, bytes.data() + first, size);
  return true;
}

bool storeScalar(std::string_view text, const PointField& field, char* to) {
  if (field.kind == ScalarKind::Signed) return storeInteger<std::int64_t>(text, field.size, to);
  if (field.kind == ScalarKind::Unsigned) return storeInteger<std::uint64_t>(text, field.size, to);
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || fault == std::errc::invalid_argument) return false;
  if (fault != std::errc()) value = std::numeric_limits<double>::quiet_NaN();
  // Packed colours are floats so small that only the cast itself may judge them.
  const float narrow = toFloat(value);
  std::memcpy(to, field.size == 4 ? static_cast<const void*>(&narrow) : &value, field.size);
  return true;
}

class Columns {
 public:
  explicit Columns(const PointTable& table) : m_table(table) {}

  const PointField* find(std::string_view name) const {
    const auto found = std::ranges::find(m_table.fields, name, &PointField::name);
    return found == m_table.fields.end() ? nullptr : &*found;
  }
  const PointField* find(std::string_view name, std::size_t size) const {
    const PointField* field = find(name);
    return field && field->size == size ? field : nullptr;
  }
  const char* at(const PointField& field, std::size_t point) const {
    return m_table.bytes.data() + field.offset + point * field.stride;
  }
  double value(const PointField& field, std::size_t point) const {
    return loadScalar(field, at(field, point), m_table.bigEndian);
  }
  std::uint32_t bits(const PointField& field, std::size_t point) const {
    return load<std::uint32_t>(at(field, point), m_table.bigEndian);
  }

 private:
  const PointTable& m_table;
};

std::shared_ptr<Cloud> gatherPoints(const PointTable& table, const std::string& where) {
  const Columns columns(table);
  std::array<const PointField*, 3> axes{columns.find("x"), columns.find("y"), columns.find("z")};
  if (std::ranges::count(axes, nullptr) > 0) {
    throw Error(where, "it has no fields x, y and z", "Give a file of 3-D points.");
  }
  auto cloud = std::make_shared<Cloud>();
  cloud->width = table.width;
  cloud->height = table.height;
  cloud->points.resize(table.points());
  for (std::size_t k = 0; k < cloud->points.size(); ++k) {
    Eigen::Vector3f p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = toFloat(columns.value(*axes[static_cast<std::size_t>(axis)], k));
    }
    const bool measured = isMeasured(p) && !p.isZero(0.0F);
    cloud->points[k] = measured ? p : unmeasuredPoint();
  }
  return cloud;
}

cv::Mat gatherImage(const PointTable& table) {
  const Columns columns(table);
  if (table.height <= 1) return {};
  const PointField* packed = columns.find("rgb", 4);
  if (!packed) packed = columns.find("rgba", 4);
  const std::array<const PointField*, 3> parts{columns.find("blue", 1), columns.find("green", 1),
                                               columns.find("red", 1)};
  if (!packed && std::ranges::count(parts, nullptr) > 0) return {};
  cv::Mat image(table.height, table.width, CV_8UC3);
  auto* pixel = image.ptr<cv::Vec3b>();
  for (std::size_t k = 0; k < table.points(); ++k) {
    const std::uint32_t bits = packed ? columns.bits(*packed, k) : 0;
    for (unsigned c = 0; c < 3; ++c) {
      const auto value = packed ? static_cast<std::uint8_t>(bits >> (8 * c))
                                : static_cast<std::uint8_t>(*columns.at(*parts[c], k));
      pixel[k][static_cast<int>(c)] = value;
    }
  }
  return image;
}

std::vector<std::uint32_t> gatherLabels(const PointTable& table) {
  const Columns columns(table);
  const PointField* field = columns.find("label");
  std::vector<std::uint32_t> labels(field ? table.points() : 0);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const double value = columns.value(*field, k);
    labels[k] = value >= 0.0 && value <= 4294967295.0 ? static_cast<std::uint32_t>(value) : 0;
  }
  return labels;
}

}  // namespace

std::size_t layOutRecords(std::vector<PointField>& fields) {
  std::size_t record = 0;
  for (PointField& field : fields) {
    field.offset = record;
    record += field.size * field.count;
  }
  for (PointField& field : fields) field.stride = record;
  return record;
}

bool parseRecord(std::string_view line, const std::vector<PointField>& fields, char* record) {
  const auto texts = words(line);
  std::size_t next = 0;
  for (const PointField& field : fields) {
    for (std::size_t k = 0; k < field.count; ++k, ++next) {
      char* to = record + field.offset + k * field.size;
      if (next >= texts.size() || !storeScalar(texts[next], field, to)) return false;
    }
  }
  return next == texts.size();
}

void readTextRecords(std::string_view text, std::size_t firstLine, const std::string& where,
                     PointTable& table) {
  table.bigEndian = std::endian::native == std::endian::big;
  const std::size_t record = layOutRecords(table.fields);
  std::size_t numbers = 0;
  for (const PointField& field : table.fields) numbers += field.count;
  // A number takes at least one character and the blank after it.
  if (table.points() > (text.size() + 1) / (2 * std::max<std::size_t>(numbers, 1))) {
    throw Error(where, "it is too short for the points its header claims",
                "The file is truncated: copy it again.");
  }
  table.storage.resize(table.points() * record);
  LineReader lines(text, firstLine);
  for (std::size_t k = 0; k < table.points();) {
    const auto line = lines.next();
    if (!line) {
      throw Error(where, "it ends after " + std::to_string(k) + " points",
                  "The file is truncated: copy it again.");
    }
    if (line->find_first_not_of(" \t\r") == std::string_view::npos) continue;
    if (!parseRecord(*line, table.fields, table.storage.data() + k * record)) {
      throw Error(where + ", line " + std::to_string(lines.lineNumber()),
                  "expected " + std::to_string(numbers) + " numbers of the fields' types",
                  "Correct the line or write the file anew.");
    }
    ++k;
  }
  table.bytes = table.storage;
}

CloudFile toCloudFile(const PointTable& table, const std::string& where) {
  return {gatherPoints(table, where), gatherImage(table), gatherLabels(table)};
}

}  // namespace boomwatch
