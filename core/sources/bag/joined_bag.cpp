#include "sources/bag/joined_bag.h"

#include <algorithm>

#include "base/error.h"
#include "files/line_reader.h"
#include "sources/file_sequence.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

/// Several files as one: `place` of a message is kept, and its topic tells the file.
class JoinedBag : public BagFile {
 public:
  explicit JoinedBag(std::vector<std::unique_ptr<BagFile>> parts) : m_parts(std::move(parts)) {
    for (std::size_t part = 0; part < m_parts.size(); ++part) add(part);
    std::ranges::stable_sort(m_messages, {}, &BagMessage::time);
  }

  std::optional<std::string> read(const BagMessage& message) override {
    // The offset's upper half tells the part, its lower half is the part's own.
    BagMessage own = message;
    const auto part = static_cast<std::size_t>(message.offset >> partShift);
    own.offset = message.offset & ((std::uint64_t(1) << partShift) - 1);
    return m_parts[part]->read(own);
  }

 private:
  static constexpr int partShift = 48;

  void add(std::size_t part) {
    const BagFile& bag = *m_parts[part];
    std::vector<std::size_t> topics;
    for (const BagTopic& topic : bag.topics()) {
      const auto known = std::ranges::find(m_topics, topic.name, &BagTopic::name);
      topics.push_back(static_cast<std::size_t>(known - m_topics.begin()));
      if (known == m_topics.end()) m_topics.push_back(topic);
    }
    for (BagMessage message : bag.messages()) {
      message.topic = topics[message.topic];
      message.offset |= static_cast<std::uint64_t>(part) << partShift;
      m_messages.push_back(message);
    }
    if (!bag.damage().empty()) m_damage += (m_damage.empty() ? "" : ", ") + bag.damage();
  }

  std::vector<std::unique_ptr<BagFile>> m_parts;
};

}  // namespace

bool isBagFile(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  return extension == ".bag" || extension == ".mcap" || extension == ".db3";
}

std::unique_ptr<BagFile> openBagPath(const fs::path& path) {
  std::error_code fault;
  if (!fs::is_directory(path, fault)) {
    auto bag = openBagFile(path);
    if (!bag->messages().empty()) return bag;
    const std::string why = bag->damage().empty() ? "" : ", and " + bag->damage();
    throw Error(path.string(), "this bag holds no message" + why, "Record it again.");
  }
  std::vector<std::unique_ptr<BagFile>> parts;
  for (const fs::path& file : listFiles(path, isBagFile)) parts.push_back(openBagFile(file));
  if (parts.empty()) {
    throw Error(path.string(), "there is no .bag, .mcap or .db3 file in this folder",
                "Check the path.");
  }
  if (parts.size() == 1) return std::move(parts.front());
  return std::make_unique<JoinedBag>(std::move(parts));
}

std::pair<fs::path, std::string> splitBagPath(const std::string& path) {
  std::size_t begin = std::string::npos;
  for (const char* key : {",left=", ",right=", ",depth=", ",colour=", ",cloud="}) {
    begin = std::min(begin, path.find(key));
  }
  if (begin == std::string::npos) return {path, ""};
  return {path.substr(0, begin), path.substr(begin + 1)};
}

}  // namespace boomwatch
