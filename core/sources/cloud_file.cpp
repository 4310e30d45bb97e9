#include "sources/cloud_file.h"

#include "base/error.h"
#include "files/file_bytes.h"
#include "files/line_reader.h"
#include "sources/pcd_file.h"
#include "sources/ply_file.h"
#include "sources/point_table.h"

namespace boomwatch {

bool isCloudFile(const std::filesystem::path& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".pcd" || extension == ".ply";
}

CloudFile readCloudFile(const std::filesystem::path& file) {
  const std::string where = file.string();
  if (!isCloudFile(file)) throw Error(where, "not a cloud", "Give a .pcd or a .ply file.");
  const std::string bytes = readFileBytes(file, PointTable::maxBytes);
  PointTable table;
  if (lowerExtension(file) == ".pcd") {
    readPcd(bytes, where, table);
  } else {
    readPly(bytes, where, table);
  }
  return toCloudFile(table, where);
}

}  // namespace boomwatch
