#include "sources/bag/bag_file.h"

#include <array>
#include <fstream>
#include <string_view>

#include "base/error.h"
#include "sources/bag/mcap_bag.h"
#include "sources/bag/ros1_bag.h"
#include "sources/bag/sqlite_bag.h"

namespace boomwatch {

std::unique_ptr<BagFile> openBagFile(const std::filesystem::path& file) {
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault)) {
    throw Error(file.string(), "there is no such file", "Give bag:FILE.");
  }
  std::array<char, 16> head{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), head.size());
  const std::string_view begin(head.data(), static_cast<std::size_t>(stream.gcount()));
  if (begin.starts_with("#ROSBAG V2.0\n")) return openRos1Bag(file);
  if (begin.starts_with("\x89MCAP0\r\n")) return openMcapBag(file);
  if (begin.starts_with("SQLite format 3")) return openSqliteBag(file);
  if (begin.starts_with("#ROSBAG V1")) {
    throw Error(file.string(), "this bag is of ROS's format 1", "Convert it with: rosbag fix.");
  }
  if (begin.starts_with("\x28\xB5\x2F\xFD")) {
    throw Error(file.string(), "the whole file is compressed", "Unpack it with: zstd -d.");
  }
  throw Error(file.string(), "this is no bag: neither ROS 1, nor MCAP, nor ROS 2's sqlite",
              "Give a .bag, .mcap or .db3 file.");
}

std::string withoutMsg(std::string type) {
  if (const auto at = type.find("/msg/"); at != std::string::npos) type.erase(at, 4);
  return type;
}

}  // namespace boomwatch
