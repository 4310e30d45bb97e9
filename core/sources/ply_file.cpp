#include "sources/ply_file.h"

#include <algorithm>

#include "base/error.h"
#include "files/line_reader.h"
#include "sources/point_table.h"

namespace boomwatch {
namespace {

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PointField> fields;
  bool hasList = false;
};

struct PlyHeader {
  std::string_view format;
  std::vector<PlyElement> elements;
  std::optional<std::size_t> columns, rows;  ///< obj_info num_cols, num_rows
  std::string_view body;
  std::size_t lines = 0;
};

constexpr std::size_t maxHeader = 65536;

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw Error(where, what, "Write the file anew as a PLY of vertices with x, y and z.");
}

std::optional<PointField> fieldOf(std::string_view type, std::string_view name) {
  struct Type {
    std::string_view name, other;
    ScalarKind kind;
    std::size_t size;
  };
  constexpr Type types[] = {
      {"char", "int8", ScalarKind::Signed, 1},    {"uchar", "uint8", ScalarKind::Unsigned, 1},
      {"short", "int16", ScalarKind::Signed, 2},  {"ushort", "uint16", ScalarKind::Unsigned, 2},
      {"int", "int32", ScalarKind::Signed, 4},    {"uint", "uint32", ScalarKind::Unsigned, 4},
      {"float", "float32", ScalarKind::Float, 4}, {"double", "float64", ScalarKind::Float, 8},
      {"long", "int64", ScalarKind::Signed, 8},   {"ulong", "uint64", ScalarKind::Unsigned, 8},
  };
  for (const Type& known : types) {
    if (type == known.name || type == known.other) {
      return PointField{std::string(name), known.kind, known.size, 1, 0, 0};
    }
  }
  return std::nullopt;
}

void addElement(const std::vector<std::string_view>& line, const std::string& place,
                PlyHeader& header) {
  const auto count = line.size() == 3 ? toNumber<std::uint64_t>(line[2]) : std::nullopt;
  if (!count) refuse(place, "element needs a name and a whole number, not below 0");
  header.elements.push_back({std::string(line[1]), *count, {}, false});
}

void addProperty(const std::vector<std::string_view>& line, const std::string& place,
                 PlyHeader& header) {
  if (header.elements.empty()) refuse(place, "a property before any element");
  PlyElement& element = header.elements.back();
  if (line.size() == 5 && line[1] == "list") {
    element.hasList = true;
    return;
  }
  const auto field = line.size() == 3 ? fieldOf(line[1], line[2]) : std::nullopt;
  if (!field) refuse(place, "this is not a property of a known type");
  element.fields.push_back(*field);
}

/// Stanford's range grids and PCL keep an organised cloud's size in these comments.
void noteSize(const std::vector<std::string_view>& line, PlyHeader& header) {
  if (line.size() != 3) return;
  if (line[1] == "num_cols") header.columns = toNumber<std::uint64_t>(line[2]);
  if (line[1] == "num_rows") header.rows = toNumber<std::uint64_t>(line[2]);
}

PlyHeader readHeader(std::string_view bytes, const std::string& where) {
  PlyHeader header;
  LineReader lines(bytes.substr(0, maxHeader));
  if (words(lines.next().value_or("")) != std::vector<std::string_view>{"ply"}) {
    refuse(where, "it does not begin with 'ply'");
  }
  while (const auto text = lines.next()) {
    const auto line = words(*text);
    if (line.empty() || line[0] == "comment") continue;
    const std::string place = where + ", line " + std::to_string(lines.lineNumber());
    if (line[0] == "format" && line.size() == 3) {
      header.format = line[1];
    } else if (line[0] == "element") {
      addElement(line, place, header);
    } else if (line[0] == "property") {
      addProperty(line, place, header);
    } else if (line[0] == "obj_info") {
      noteSize(line, header);
    } else if (line[0] == "end_header") {
      header.lines = lines.lineNumber();
      header.body = bytes.substr(std::min(bytes.size(), maxHeader) - lines.rest().size());
      return header;
    } else {
      refuse(place, "this is not a line of a PLY header");
    }
  }
  refuse(where, "its header has no end: it is truncated or not a PLY");
}

void setSize(const PlyHeader& header, std::size_t count, const std::string& where,
             PointTable& table) {
  if (count == 0) refuse(where, "it holds no points");
  if (count > PointTable::maxPoints) {
    refuse(where, "it claims more than " + std::to_string(PointTable::maxPoints) + " points");
  }
  table.width = static_cast<int>(count);
  table.height = 1;
  const std::size_t columns = header.columns.value_or(0);
  const std::size_t rows = header.rows.value_or(0);
  if (columns > 0 && columns <= count && count % columns == 0 && count / columns == rows) {
    table.width = static_cast<int>(columns);
    table.height = static_cast<int>(rows);
  }
}

/// The text after what lies before the vertices.
LineReader skipText(const PlyHeader& header, std::size_t skipped) {
  LineReader lines(header.body, header.lines);
  while (skipped > 0 && lines.next()) --skipped;
  return lines;
}

void readBinary(std::string_view body, std::size_t skipped, const std::string& where,
                PointTable& table) {
  const std::size_t wanted = layOutRecords(table.fields) * table.points();
  const std::size_t present = body.size() - std::min(body.size(), skipped);
  if (wanted > present) {
    throw Error(where,
                "its header claims " + std::to_string(wanted) + " bytes of points, but " +
                    std::to_string(present) + " are there",
                "The file is truncated: copy it again.");
  }
  table.bytes = body.substr(skipped);
}

}  // namespace

void readPly(std::string_view bytes, const std::string& where, PointTable& table) {
  PlyHeader header = readHeader(bytes, where);
  const bool isText = header.format == "ascii";
  if (!isText && header.format != "binary_little_endian" && header.format != "binary_big_endian") {
    refuse(where, "its format is neither ascii, binary_little_endian nor binary_big_endian");
  }
  std::size_t skipped = 0;  // lines or bytes
  for (PlyElement& element : header.elements) {
    const bool isVertex = element.name == "vertex";
    if (element.hasList && (isVertex || !isText)) {
      refuse(where, "lists in or before its vertices are not understood");
    }
    if (isVertex) {
      table.fields = std::move(element.fields);
      setSize(header, element.count, where, table);
      if (isText) {
        const LineReader lines = skipText(header, skipped);
        return readTextRecords(lines.rest(), lines.lineNumber(), where, table);
      }
      table.bigEndian = header.format == "binary_big_endian";
      return readBinary(header.body, skipped, where, table);
    }
    const std::size_t record = isText ? 1 : std::max<std::size_t>(layOutRecords(element.fields), 1);
    if (element.count > bytes.size() / record) {
      refuse(where, "element '" + element.name + "' is longer than the file");
    }
    skipped += element.count * record;
  }
  refuse(where, "it has no element 'vertex'");
}

}  // namespace boomwatch
