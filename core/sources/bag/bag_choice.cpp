#include "sources/bag/bag_choice.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "files/line_reader.h"
#include "sources/bag/bag_picture.h"

namespace boomwatch {
namespace {

using SidePair = std::pair<std::string_view, std::string_view>;
constexpr std::array<SidePair, 7> sideWords{{{"left", "right"},
                                             {"infra1", "infra2"},
                                             {"cam0", "cam1"},
                                             {"camera0", "camera1"},
                                             {"camera_0", "camera_1"},
                                             {"image_0", "image_1"},
                                             {"image_2", "image_3"}}};

std::vector<std::string_view> partsOf(std::string_view name) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin < name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (end > begin) parts.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::size_t sharedParts(std::string_view a, std::string_view b) {
  const auto x = partsOf(a), y = partsOf(b);
  const auto end = std::ranges::mismatch(x, y).in1;
  return static_cast<std::size_t>(end - x.begin());
}

// Every place of `from` becomes `to`; absent where there is none.
std::optional<std::string> replaced(std::string name, std::string_view from, std::string_view to) {
  bool any = false;
  for (auto at = name.find(from); at != std::string::npos; at = name.find(from, at + to.size())) {
    name.replace(at, from.size(), to);
    any = true;
  }
  if (!any) return std::nullopt;
  return name;
}

/// What the first messages of the topics tell.
class Topics {
 public:
  explicit Topics(BagFile& bag) : m_bag(bag) {
    std::vector<bool> seen(bag.topics().size());
    for (const BagMessage& message : bag.messages()) {
      if (seen[message.topic]) continue;
      seen[message.topic] = true;
      examine(message);
    }
  }

  const std::map<std::size_t, cv::Mat>& pictures() const { return m_pictures; }
  const std::map<std::size_t, cv::Mat>& depths() const { return m_depths; }
  const std::vector<std::size_t>& clouds() const { return m_clouds; }

  std::optional<std::size_t> picture(std::string_view name) const {
    for (const auto& [topic, image] : m_pictures) {
      if (m_bag.topics()[topic].name == name) return topic;
    }
    return std::nullopt;
  }

  /// Of the info whose name shares most with the topic's.
  std::optional<std::size_t> infoOf(std::size_t topic) const {
    const std::string& name = m_bag.topics()[topic].name;
    std::optional<std::size_t> best;
    std::size_t most = 0;
    for (const auto& [info, camera] : m_cameras) {
      const std::string& other = m_bag.topics()[info].name;
      std::size_t score = 4 * sharedParts(name, other) + 1;
      for (const auto& [left, right] : sideWords) {
        for (const std::string_view side : {left, right}) {
          const bool both =
              name.find(side) != std::string::npos && other.find(side) != std::string::npos;
          if (both) score += 2;
        }
      }
      if (score > most) {
        most = score;
        best = info;
      }
    }
    return best;
  }
  std::optional<BagCamera> cameraOf(std::size_t topic) const {
    const auto info = infoOf(topic);
    if (!info) return std::nullopt;
    return m_cameras.at(*info);
  }

 private:
  void examine(const BagMessage& message) {
    const BagTopic& topic = m_bag.topics()[message.topic];
    const bool isPicture = isPictureType(topic.type), isCamera = isCameraType(topic.type);
    if (topic.type == "sensor_msgs/PointCloud2") m_clouds.push_back(message.topic);
    if (topic.encoding == BagEncoding::Other || (!isPicture && !isCamera)) return;
    const auto bytes = m_bag.read(message);
    if (!bytes) return;
    if (isCamera) {
      if (const auto camera = decodeCamera(topic, *bytes)) m_cameras[message.topic] = *camera;
      return;
    }
    const cv::Mat image = decodePicture(topic, *bytes).image;
    if (image.empty()) return;
    const bool isDepth = image.depth() != CV_8U;
    (isDepth ? m_depths : m_pictures)[message.topic] = image;
  }

  BagFile& m_bag;
  std::map<std::size_t, cv::Mat> m_pictures, m_depths;
  std::map<std::size_t, BagCamera> m_cameras;
  std::vector<std::size_t> m_clouds;
};

// Of the forms in which one camera's pictures are recorded, the lowest is the best.
int rankOf(std::string_view name) {
  return (namesRectified(name) ? 0 : 2) +
         (name.find("ompressed") == std::string_view::npos ? 0 : 1);
}

/// Keeps the best of those with the same camera.
void keepBest(const BagFile& bag, const Topics& topics, std::vector<BagChoice>& choices) {
  std::ranges::stable_sort(choices, {}, [&](const BagChoice& choice) {
    return rankOf(bag.topics()[choice.first].name);
  });
  std::vector<BagChoice> kept;
  for (BagChoice& choice : choices) {
    const auto info = topics.infoOf(choice.first);
    const bool known = info && std::ranges::any_of(kept, [&](const BagChoice& other) {
                         return topics.infoOf(other.first) == info;
                       });
    if (!known) kept.push_back(std::move(choice));
  }
  choices = std::move(kept);
}

std::vector<BagChoice> stereoChoices(const BagFile& bag, const Topics& topics) {
  std::vector<BagChoice> found;
  for (const auto& [topic, image] : topics.pictures()) {
    for (const auto& [left, right] : sideWords) {
      const auto partner = replaced(bag.topics()[topic].name, left, right);
      const auto other = partner ? topics.picture(*partner) : std::nullopt;
      if (!other) continue;
      found.push_back(
          {BagKind::Stereo, topic, other, topics.cameraOf(topic), topics.cameraOf(*other)});
      break;
    }
  }
  keepBest(bag, topics, found);
  return found;
}

bool seesTheSame(const BagCamera& a, const BagCamera& b) {
  return a.size == b.size && cv::norm(a.matrix - b.matrix, cv::NORM_INF) < 1.0;
}

std::vector<BagChoice> depthChoices(const BagFile& bag, const Topics& topics) {
  std::vector<BagChoice> found;
  for (const auto& [topic, image] : topics.depths()) {
    BagChoice choice{BagKind::Depth, topic, std::nullopt, topics.cameraOf(topic), std::nullopt};
    for (const auto& [picture, colour] : topics.pictures()) {
      const auto camera = topics.cameraOf(picture);
      const bool fits = choice.camera && camera && colour.size() == image.size() &&
                        seesTheSame(*choice.camera, *camera);
      if (fits && !choice.second) choice.second = picture;
    }
    found.push_back(std::move(choice));
  }
  keepBest(bag, topics, found);
  return found;
}

std::vector<BagChoice> allChoices(const BagFile& bag, const Topics& topics) {
  std::vector<BagChoice> all = stereoChoices(bag, topics);
  for (BagChoice& choice : depthChoices(bag, topics)) all.push_back(std::move(choice));
  for (const std::size_t topic : topics.clouds()) {
    all.push_back({BagKind::Cloud, topic, std::nullopt, std::nullopt, std::nullopt});
  }
  return all;
}

std::string listOf(const BagFile& bag) {
  std::string list;
  for (const BagTopic& topic : bag.topics()) {
    if (topic.name.empty() || list.size() > 2000) continue;
    list += (list.empty() ? "" : ", ") + topic.name + " (" + topic.type + ")";
  }
  return list.empty() ? "no topic" : list;
}

/// The topics that an option names, by its keys.
std::map<std::string, std::size_t> namedTopics(const BagFile& bag, const std::string& option,
                                               const std::string& where) {
  std::map<std::string, std::size_t> named;
  for (std::size_t begin = 0; begin < option.size();) {
    const std::size_t end = std::min(option.find(',', begin), option.size());
    const std::string item = option.substr(begin, end - begin);
    begin = end + 1;
    const auto equals = item.find('=');
    const std::string name = equals == std::string::npos ? item : item.substr(equals + 1);
    const auto topic = std::ranges::find(bag.topics(), name, &BagTopic::name);
    if (topic == bag.topics().end()) {
      throw Error(where, "it has no topic '" + name + "'", "Give one of " + listOf(bag) + ".");
    }
    named[item.substr(0, std::min(equals, item.size()))] =
        static_cast<std::size_t>(topic - bag.topics().begin());
  }
  return named;
}

BagChoice choiceNamed(const BagFile& bag, const Topics& topics, const std::string& option,
                      const std::string& where) {
  const auto named = namedTopics(bag, option, where);
  const auto at = [&](const char* key) -> std::optional<std::size_t> {
    const auto found = named.find(key);
    if (found == named.end()) return std::nullopt;
    return found->second;
  };
  BagChoice choice;
  if (at("left") && at("right") && named.size() == 2) {
    choice = {BagKind::Stereo, *at("left"), at("right"), {}, topics.cameraOf(*at("right"))};
  } else if (at("depth") && named.size() == (at("colour") ? 2u : 1u)) {
    choice = {BagKind::Depth, *at("depth"), at("colour"), {}, {}};
  } else if (at("cloud") && named.size() == 1) {
    return {BagKind::Cloud, *at("cloud"), {}, {}, {}};
  } else {
    throw Error(where, "'" + option + "' chooses no source",
                "Give left=TOPIC,right=TOPIC or depth=TOPIC[,colour=TOPIC] or cloud=TOPIC.");
  }
  choice.camera = topics.cameraOf(choice.first);
  return choice;
}

}  // namespace

bool namesRectified(std::string_view topic) {
  constexpr std::string_view partings = "/_-";
  for (std::size_t begin = 0; begin < topic.size();) {
    const std::size_t end = std::min(topic.find_first_of(partings, begin), topic.size());
    const std::string word = lower(topic.substr(begin, end - begin));
    if (word == "rect" || word == "rectified") return true;
    begin = end + 1;
  }
  return false;
}

std::string optionOf(const BagFile& bag, const BagChoice& choice) {
  const auto name = [&](std::size_t topic) { return bag.topics()[topic].name; };
  switch (choice.kind) {
    case BagKind::Stereo:
      return "left=" + name(choice.first) + ",right=" + name(*choice.second);
    case BagKind::Depth:
      return "depth=" + name(choice.first) +
             (choice.second ? ",colour=" + name(*choice.second) : "");
    case BagKind::Cloud:
      break;
  }
  return "cloud=" + name(choice.first);
}

std::vector<BagChoice> choicesIn(BagFile& bag) { return allChoices(bag, Topics(bag)); }

BagChoice chooseTopics(BagFile& bag, const std::string& option, const std::string& where) {
  const Topics topics(bag);
  if (!option.empty()) return choiceNamed(bag, topics, option, where);
  const auto all = allChoices(bag, topics);
  if (all.size() == 1) return all.front();
  if (all.empty()) {
    throw Error(where, "it holds no stereo pair, no depth and no cloud, but " + listOf(bag),
                "Record pictures of two cameras, depth pictures or point clouds.");
  }
  std::string list;
  for (const BagChoice& choice : all) {
    list += (list.empty() ? "bag:FILE," : " or bag:FILE,") + optionOf(bag, choice);
  }
  throw Error(where, "it holds " + std::to_string(all.size()) + " sources", "Give " + list + ".");
}

}  // namespace boomwatch
