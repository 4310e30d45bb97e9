#include "sources/bag/bag_pairs.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "base/median.h"
#include "sources/bag/bag_picture.h"

namespace boomwatch {
namespace {

struct Stamped {
  std::int64_t stamp = 0;
  BagMessage message;
};

// In the order of the file, so that each chunk is unpacked once.
std::map<std::size_t, std::vector<Stamped>> stampedMessages(BagFile& bag, const BagChoice& choice) {
  std::map<std::size_t, std::vector<Stamped>> lists;
  for (const BagMessage& message : bag.messages()) {
    if (message.topic != choice.first && message.topic != choice.second) continue;
    const auto bytes = bag.read(message);
    const std::int64_t stamp = bytes ? stampIn(bag.topics()[message.topic], *bytes) : 0;
    lists[message.topic].push_back({stamp > 0 ? stamp : message.time, message});
  }
  for (auto& [topic, list] : lists) std::ranges::stable_sort(list, {}, &Stamped::stamp);
  return lists;
}

// The usual time between two pictures; far apart where there is one alone.
std::int64_t periodOf(const std::vector<Stamped>& list) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < list.size(); ++k) {
    const std::int64_t step = list[k].stamp - list[k - 1].stamp;
    if (step > 0) steps.push_back(static_cast<double>(step));
  }
  constexpr std::int64_t second = 1'000'000'000;
  return steps.empty() ? second : static_cast<std::int64_t>(medianOf(steps));
}

}  // namespace

BagPairs pairMessages(BagFile& bag, const BagChoice& choice) {
  auto lists = stampedMessages(bag, choice);
  const std::vector<Stamped>& first = lists[choice.first];
  std::vector<BagPair> pairs;
  const bool needsPartner = choice.kind == BagKind::Stereo;
  static const std::vector<Stamped> none;
  const std::vector<Stamped>& second = choice.second ? lists[*choice.second] : none;
  const std::int64_t reach = periodOf(first) / 2;
  std::size_t next = 0;
  for (const Stamped& one : first) {
    const auto distance = [&](std::size_t k) { return std::abs(second[k].stamp - one.stamp); };
    while (next + 1 < second.size() && distance(next + 1) <= distance(next)) ++next;
    const bool found = next < second.size() && distance(next) <= reach;
    if (found) {
      pairs.push_back({one.stamp, one.message, second[next].message});
      ++next;  // a picture belongs to one pair
    } else if (!needsPartner) {
      pairs.push_back({one.stamp, one.message, std::nullopt});
    }
  }
  const std::size_t unpaired =
      needsPartner ? first.size() + second.size() - 2 * pairs.size() : std::size_t{0};
  return {std::move(pairs), unpaired};
}

}  // namespace boomwatch
