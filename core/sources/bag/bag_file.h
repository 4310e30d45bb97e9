#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace boomwatch {

/// How the bytes of a message are laid out.
enum class BagEncoding {
  Ros1,   ///< ROS 1's serialisation
  Cdr,    ///< ROS 2's
  Json,   ///< as foxglove's schemas are written in text
  Other,  ///< not read here
};

/// A named stream of messages.
struct BagTopic {
  std::string name;  ///< "/camera/left/image_raw"
  std::string type;  ///< "sensor_msgs/Image", without ROS 2's "/msg"
  BagEncoding encoding = BagEncoding::Other;
};

/// Where a message lies; what the numbers mean is the format's own affair.
struct BagMessage {
  std::size_t topic = 0;     ///< index into BagFile::topics
  std::int64_t time = 0;     ///< when it was recorded, nanoseconds
  std::uint64_t place = 0;   ///< of its chunk or record
  std::uint64_t offset = 0;  ///< within a chunk
};

/// A recording of messages, open for reading: ROS 1 (.bag), MCAP or ROS 2's sqlite (.db3). Used by
/// one thread.
class BagFile {
 public:
  virtual ~BagFile() = default;

  const std::vector<BagTopic>& topics() const { return m_topics; }
  /// By the time of their recording.
  const std::vector<BagMessage>& messages() const { return m_messages; }
  /// English: what of the file could not be read; empty when it is whole.
  const std::string& damage() const { return m_damage; }

  /// Absent where the file is damaged there.
  virtual std::optional<std::string> read(const BagMessage& message) = 0;

 protected:
  std::vector<BagTopic> m_topics;
  std::vector<BagMessage> m_messages;
  std::string m_damage;
};

/// Opens a bag by its first bytes. A damaged one gives what is whole of it. Throws Error when it is
/// none, or no message of it can be found.
std::unique_ptr<BagFile> openBagFile(const std::filesystem::path& file);

/// "sensor_msgs/msg/Image" -> "sensor_msgs/Image".
std::string withoutMsg(std::string type);

}  // namespace boomwatch
