#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sources/cloud_file.h"

namespace boomwatch {

enum class ScalarKind { Signed, Unsigned, Float };

/// A column of a point table: the scalar of point k lies at `offset + k * stride`.
struct PointField {
  std::string name;
  ScalarKind kind = ScalarKind::Float;
  std::size_t size = 4;   ///< bytes of one scalar: 1, 2, 4 or 8
  std::size_t count = 1;  ///< scalars a point; only the first is read
  std::size_t offset = 0;
  std::size_t stride = 0;
};

/// Points as PCD and PLY lay them out, record by record or column by column.
///
/// Whoever fills it has checked that `bytes` holds every scalar of every field.
struct PointTable {
  static constexpr std::size_t maxPoints = 50'000'000;
  static constexpr std::size_t maxBytes = std::size_t{1} << 31;

  int width = 0;
  int height = 1;
  bool bigEndian = false;
  std::vector<PointField> fields;
  std::string_view bytes;  ///< in the file's own bytes or in `storage`
  std::string storage;     ///< what had to be unpacked

  PointTable() = default;
  PointTable(const PointTable&) = delete;  // `bytes` may look into `storage`
  PointTable& operator=(const PointTable&) = delete;

  std::size_t points() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Gives the fields the offsets of a table of records one after the other; returns a record's size.
std::size_t layOutRecords(std::vector<PointField>& fields);

/// Writes the scalars of one line of text to `record`, as the fields' offsets say. False when the
/// line does not hold exactly one number for each.
bool parseRecord(std::string_view line, const std::vector<PointField>& fields, char* record);

/// Reads lines of text, one record each, into `storage`; empty lines are skipped. Throws Error
/// naming `where` and the line when one does not fit or the text ends early.
void readTextRecords(std::string_view text, std::size_t firstLine, const std::string& where,
                     PointTable& table);

/// Throws Error naming `where` when x, y or z is absent.
CloudFile toCloudFile(const PointTable& table, const std::string& where);

}  // namespace boomwatch
