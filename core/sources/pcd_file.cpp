#include "sources/pcd_file.h"

#include <pcl/io/lzf.h>

#include "base/error.h"
#include "files/line_reader.h"
#include "sources/point_table.h"

// PCL's own reader allocates what a header claims before it looks at the file, and prints. Only its
// decompression, which is bounded by its arguments, is used here; tests compare the rest with it.
namespace boomwatch {
namespace {

using Words = std::vector<std::string_view>;

struct PcdHeader {
  Words names, sizes, types, counts;
  std::optional<std::size_t> width, height, points;
  std::string_view encoding;
  std::string_view data;  ///< what follows the header
  std::size_t lines = 0;
};

constexpr std::size_t maxHeader = 65536;
constexpr std::size_t maxRecord = 65536;

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw Error(where, what, "Write the file anew as PCD 0.7.");
}

std::size_t wholeNumber(const Words& line, const std::string& where) {
  const auto value =
      line.size() == 2 ? toNumber<std::uint64_t>(line[1]) : std::optional<std::uint64_t>();
  if (value) return *value;
  refuse(where, std::string(line[0]) + " needs one whole number, not below 0");
}

Words tail(const Words& line) { return {line.begin() + 1, line.end()}; }

PcdHeader readHeader(std::string_view bytes, const std::string& where) {
  PcdHeader header;
  LineReader lines(bytes.substr(0, maxHeader));
  while (const auto text = lines.next()) {
    const Words line = words(*text);
    if (line.empty() || line[0].starts_with('#')) continue;
    const std::string place = where + ", line " + std::to_string(lines.lineNumber());
    const std::string_view key = line[0];
    if (key == "FIELDS" || key == "COLUMNS") {
      header.names = tail(line);
    } else if (key == "SIZE") {
      header.sizes = tail(line);
    } else if (key == "TYPE") {
      header.types = tail(line);
    } else if (key == "COUNT") {
      header.counts = tail(line);
    } else if (key == "WIDTH") {
      header.width = wholeNumber(line, place);
    } else if (key == "HEIGHT") {
      header.height = wholeNumber(line, place);
    } else if (key == "POINTS") {
      header.points = wholeNumber(line, place);
    } else if (key == "DATA") {
      if (line.size() != 2) refuse(place, "DATA needs one word");
      header.encoding = line[1];
      header.lines = lines.lineNumber();
      header.data = bytes.substr(std::min(bytes.size(), maxHeader) - lines.rest().size());
      return header;
    } else if (key != "VERSION" && key != "VIEWPOINT") {
      refuse(place, "this is not a line of a PCD header");
    }
  }
  refuse(where, "its header has no DATA line: it is truncated or not a PCD");
}

PointField readField(const PcdHeader& header, std::size_t k, const std::string& where) {
  const std::string name(header.names[k]);
  const auto size = toNumber<std::uint64_t>(header.sizes[k]);
  const auto count =
      header.counts.empty() ? std::uint64_t{1} : toNumber<std::uint64_t>(header.counts[k]);
  const std::string_view type = header.types[k];
  const bool isFloat = type == "F";
  if (!isFloat && type != "I" && type != "U") {
    refuse(where, "field '" + name + "' has an unknown TYPE");
  }
  const bool sizeFits =
      size && (*size == 4 || *size == 8 || (!isFloat && (*size == 1 || *size == 2)));
  if (!sizeFits) refuse(where, "field '" + name + "' has a SIZE that its TYPE cannot have");
  if (!count || *count < 1 || *count > maxRecord) {
    refuse(where, "field '" + name + "' has a COUNT that is not 1 or more");
  }
  const ScalarKind kind = isFloat       ? ScalarKind::Float
                          : type == "I" ? ScalarKind::Signed
                                        : ScalarKind::Unsigned;
  return {name, kind, *size, *count, 0, 0};
}

void readFields(const PcdHeader& header, const std::string& where, PointTable& table) {
  const std::size_t n = header.names.size();
  if (n == 0) refuse(where, "its header has no FIELDS");
  if (header.sizes.size() != n || header.types.size() != n ||
      (!header.counts.empty() && header.counts.size() != n)) {
    refuse(where, "FIELDS, SIZE, TYPE and COUNT are not equally long");
  }
  for (std::size_t k = 0; k < n; ++k) table.fields.push_back(readField(header, k, where));
}

void readSize(const PcdHeader& header, const std::string& where, PointTable& table) {
  if (!header.width && !header.points) refuse(where, "its header has no WIDTH and no POINTS");
  const std::size_t height = header.height.value_or(1);
  const std::size_t width = header.width ? *header.width : *header.points;
  if (width == 0 || height == 0) refuse(where, "it holds no points");
  if (width > PointTable::maxPoints || height > PointTable::maxPoints / width) {
    refuse(where, "it claims more than " + std::to_string(PointTable::maxPoints) + " points");
  }
  if (header.points && *header.points != width * height) {
    refuse(where, "POINTS is not WIDTH times HEIGHT");
  }
  table.width = static_cast<int>(width);
  table.height = static_cast<int>(height);
}

void requireBytes(std::size_t wanted, std::size_t present, const std::string& where) {
  if (wanted <= present) return;
  throw Error(where,
              "its header claims " + std::to_string(wanted) + " bytes of points, but " +
                  std::to_string(present) + " are there",
              "The file is truncated: copy it again.");
}

std::uint32_t littleEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) << (8 * k);
  }
  return value;
}

/// Column by column, after two sizes.
void readCompressed(std::string_view data, std::size_t record, const std::string& where,
                    PointTable& table) {
  requireBytes(8, data.size(), where);
  const std::size_t packed = littleEndian(data);
  const std::size_t unpacked = littleEndian(data.substr(4));
  requireBytes(packed, data.size() - 8, where);
  if (unpacked != record * table.points()) {
    refuse(where, "its unpacked size is not that of the points its header claims");
  }
  // LZF makes at most 264 bytes of 3, so this bounds memory by the file's real size.
  if (unpacked > PointTable::maxBytes || unpacked > packed * 88) {
    refuse(where, "its compressed part is too short for its points");
  }
  table.storage.resize(unpacked);
  const auto size = pcl::lzfDecompress(data.data() + 8, static_cast<unsigned>(packed),
                                       table.storage.data(), static_cast<unsigned>(unpacked));
  if (size != unpacked) refuse(where, "its compressed part is damaged");
  table.bytes = table.storage;
  for (PointField& field : table.fields) {
    field.offset *= table.points();
    field.stride = field.size * field.count;
  }
}

}  // namespace

void readPcd(std::string_view bytes, const std::string& where, PointTable& table) {
  const PcdHeader header = readHeader(bytes, where);
  readFields(header, where, table);
  readSize(header, where, table);
  const std::size_t record = layOutRecords(table.fields);
  if (record > maxRecord) refuse(where, "a point takes more than 65536 bytes");
  if (header.encoding == "ascii") {
    readTextRecords(header.data, header.lines, where, table);
  } else if (header.encoding == "binary") {
    requireBytes(record * table.points(), header.data.size(), where);
    table.bytes = header.data;
  } else if (header.encoding == "binary_compressed") {
    readCompressed(header.data, record, where, table);
  } else {
    refuse(where, "DATA is neither ascii, binary nor binary_compressed");
  }
}

}  // namespace boomwatch
