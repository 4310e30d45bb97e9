#include "simulation/truth_json.h"

#include <array>
#include <charconv>
#include <initializer_list>

#include "simulation/yard/yard_truth.h"

namespace boomwatch {
namespace {

std::string json(double value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string json(std::initializer_list<double> values) {
  std::string text = "[";
  for (const double value : values) {
    if (text.size() > 1) text += ',';
    text += json(value);
  }
  return text + "]";
}

std::string json(const Eigen::Vector3d& p) { return json({p.x(), p.y(), p.z()}); }

using Member = std::pair<const char*, std::string>;

std::string object(std::initializer_list<Member> members) {
  std::string text = "{";
  for (const auto& [key, value] : members) {
    if (text.size() > 1) text += ',';
    text += '"';
    text += key;
    text += "\":";
    text += value;
  }
  return text + "}";
}

std::string json(const OrientedBox& box) {
  std::string axes = "[";
  for (int k = 0; k < 3; ++k) {
    if (k > 0) axes += ',';
    axes += json(Eigen::Vector3d(box.rotation.col(k)));
  }
  return object({{"centre", json(box.centre)}, {"size", json(box.size)}, {"axes", axes + "]"}});
}

std::string json(const std::optional<YardApproach>& approach) {
  if (!approach) return "null";
  std::string kind = "\"";
  kind += toString(approach->kind);
  kind += '"';
  const bool apart = approach->pair.distance > 0.0;
  return object({{"kind", kind},
                 {"distance_m", json(approach->pair.distance)},
                 {"on_load", apart ? json(approach->pair.onA) : "null"},
                 {"on_thing", apart ? json(approach->pair.onB) : "null"}});
}

std::string tool(const YardTruth& truth) {
  const cv::Rect& box = truth.toolBox;
  return object({{"point", json(truth.toolPoint)},
                 {"pixel", json({truth.toolPixel.x, truth.toolPixel.y})},
                 {"box", box.empty() ? "null"
                                     : json({double(box.x), double(box.y), double(box.width),
                                             double(box.height)})},
                 {"visible", json(truth.toolVisible)}});
}

std::string log(const Cylinder& log) {
  return object({{"centre", json(log.centre)},
                 {"axis", json(log.axis)},
                 {"length", json(log.length)},
                 {"radius", json(log.radius)}});
}

}  // namespace

std::string truthJson(const Frame& frame) {
  const YardTruth* yard = frame.truth->yard.get();
  return object({{"frame", std::to_string(frame.sequence)},
                 {"stamp", json(frame.stamp)},
                 {"distance_m", json(frame.truth->distance)},
                 {"load", frame.load ? json(*frame.load) : "null"},
                 {"log", yard ? log(yard->log) : "null"},
                 {"tool", yard ? tool(*yard) : "null"},
                 {"nearest", yard ? json(std::optional<YardApproach>(yard->nearest)) : "null"},
                 {"person", yard ? json(yard->person) : "null"},
                 {"branch", yard ? json(yard->branch) : "null"}});
}

}  // namespace boomwatch
