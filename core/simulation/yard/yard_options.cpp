#include "simulation/yard/yard_options.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>
#include <span>
#include <string_view>

#include "base/error.h"

namespace boomwatch {
namespace {

/// An option: a number within a range, or one of a few words.
struct Option {
  std::string_view key;
  std::string_view meaning;
  std::string_view standard;  ///< its default, as text
  double least = 0.0, most = 0.0;
  bool whole = false;
  std::span<const std::string_view> words;  ///< empty for a number
  /// The number, or the index of the word.
  void (*set)(YardOptions&, double);
};

constexpr std::array<std::string_view, 3> views{"stereo", "depth", "cloud"};
constexpr std::array<std::string_view, 2> paths{"scripted", "random"};
constexpr std::array<std::string_view, 2> switches{"off", "on"};

constexpr std::array<Option, 11> optionTable{{
    {"seed",
     "another yard, path and weather",
     "1",
     0,
     999999,
     true,
     {},
     [](YardOptions& o, double v) { o.seed = static_cast<std::uint64_t>(v); }},
    {"frames",
     "how many, 20 a second",
     "600",
     1,
     12000,
     true,
     {},
     [](YardOptions& o, double v) { o.frames = static_cast<std::size_t>(v); }},
    {"as", "pair of pictures; noisy depth; exact points", "stereo", 0, 0, false, views,
     [](YardOptions& o, double v) { o.as = static_cast<YardView>(static_cast<int>(v)); }},
    {"path", "stack, wall, ground, tree in turn; or any", "scripted", 0, 0, false, paths,
     [](YardOptions& o, double v) { o.path = static_cast<YardPath>(static_cast<int>(v)); }},
    {"noise",
     "of the pictures, grey levels",
     "2",
     0,
     30,
     false,
     {},
     [](YardOptions& o, double v) { o.noise = v; }},
    {"exposure",
     "swing to both sides, stops",
     "0",
     0,
     3,
     false,
     {},
     [](YardOptions& o, double v) { o.exposure = v; }},
    {"blur",
     "share of a frame's time that the shutter is open",
     "0",
     0,
     1,
     false,
     {},
     [](YardOptions& o, double v) { o.blur = v; }},
    {"rain", "1 is a downpour", "0", 0, 1, false, {}, [](YardOptions& o, double v) { o.rain = v; }},
    {"depth_noise",
     "of depth and cloud, pixels of disparity",
     "0.2 for depth, 0 for cloud",
     0,
     5,
     false,
     {},
     [](YardOptions& o, double v) { o.depthNoise = v; }},
    {"person", "someone who walks about", "on", 0, 0, false, switches,
     [](YardOptions& o, double v) { o.person = v > 0.0; }},
    {"clutter", "birds, leaves, swaying branches", "on", 0, 0, false, switches,
     [](YardOptions& o, double v) { o.clutter = v > 0.0; }},
}};

std::string rangeOf(const Option& option) {
  if (option.words.empty()) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%g..%g%s", option.least, option.most,
                  option.whole ? ", whole" : "");
    return text.data();
  }
  std::string text;
  for (const std::string_view word : option.words) {
    if (!text.empty()) text += '|';
    text += word;
  }
  return text;
}

std::optional<double> valueOf(const Option& option, std::string_view text) {
  if (!option.words.empty()) {
    const auto found = std::ranges::find(option.words, text);
    if (found == option.words.end()) return std::nullopt;
    return static_cast<double>(found - option.words.begin());
  }
  double number = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool valid = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() &&
                     number >= option.least && number <= option.most &&
                     (!option.whole || number == std::floor(number));
  return valid ? std::optional(number) : std::nullopt;
}

const Option& optionNamed(std::string_view key, const std::string& address) {
  std::string known;
  for (const Option& option : optionTable) {
    if (option.key == key) return option;
    if (!known.empty()) known += ", ";
    known += option.key;
  }
  throw Error(address, "demo:yard has no option '" + std::string(key) + "'",
              "Its options are " + known + ": demo:yard,seed=7,rain=0.5");
}

}  // namespace

YardOptions parseYardOptions(const std::string& text, const std::string& address) {
  YardOptions options;
  std::set<std::string_view> given;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view item = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), item.size() + 1));
    const auto equals = std::min(item.find('='), item.size());
    const Option& option = optionNamed(item.substr(0, equals), address);
    const std::string_view value = item.substr(std::min(item.size(), equals + 1));
    if (!given.insert(option.key).second) {
      throw Error(address, "the option " + std::string(option.key) + " is given twice",
                  "Give it once.");
    }
    const auto parsed = valueOf(option, value);
    if (!parsed) {
      throw Error(
          address,
          std::string(option.key) + " is '" + std::string(value) + "', but must be " +
              rangeOf(option),
          "Give " + std::string(option.key) + "=" + std::string(option.standard) + ", say.");
    }
    option.set(options, *parsed);
  }
  if (!given.contains("depth_noise") && options.as == YardView::Depth) options.depthNoise = 0.2;
  return options;
}

std::string yardOptionsHelp() {
  std::string help;
  for (const Option& option : optionTable) {
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "  %-12.*s %-20s [%.*s] %.*s\n",
                  static_cast<int>(option.key.size()), option.key.data(), rangeOf(option).c_str(),
                  static_cast<int>(option.standard.size()), option.standard.data(),
                  static_cast<int>(option.meaning.size()), option.meaning.data());
    help += line.data();
  }
  return help;
}

}  // namespace boomwatch
