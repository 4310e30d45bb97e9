#include "simulation/truth_json.h"

#include <nlohmann/json.hpp>

#include "simulation/yard/yard_truth.h"

namespace boomwatch {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Eigen::Vector3d& p) { return Json::array({p.x(), p.y(), p.z()}); }

Json json(const OrientedBox& box) {
  Json axes = Json::array();
  for (int k = 0; k < 3; ++k) axes.push_back(json(Eigen::Vector3d(box.rotation.col(k))));
  return {{"centre", json(box.centre)}, {"size", json(box.size)}, {"axes", axes}};
}

Json json(const YardApproach& approach) {
  const bool apart = approach.pair.distance > 0.0;
  return {{"kind", toString(approach.kind)},
          {"distance_m", approach.pair.distance},
          {"on_load", apart ? json(approach.pair.onA) : Json()},
          {"on_thing", apart ? json(approach.pair.onB) : Json()}};
}

template <class Value>
Json json(const std::optional<Value>& value) {
  return value ? json(*value) : Json();
}

Json tool(const YardTruth& truth) {
  const cv::Rect& box = truth.toolBox;
  return {{"point", json(truth.toolPoint)},
          {"pixel", Json::array({truth.toolPixel.x, truth.toolPixel.y})},
          {"box", box.empty() ? Json() : Json::array({box.x, box.y, box.width, box.height})},
          {"visible", truth.toolVisible}};
}

Json log(const Cylinder& log) {
  return {{"centre", json(log.centre)},
          {"axis", json(log.axis)},
          {"length", log.length},
          {"radius", log.radius}};
}

}  // namespace

std::string truthJson(const Frame& frame, const YardTruth* yard) {
  const Json line{{"frame", frame.sequence},
                  {"stamp", frame.stamp},
                  {"distance_m", *frame.trueDistance},
                  {"load", json(frame.load)},
                  {"log", yard ? log(yard->log) : Json()},
                  {"tool", yard ? tool(*yard) : Json()},
                  {"nearest", yard ? json(yard->nearest) : Json()},
                  {"person", yard ? json(yard->person) : Json()},
                  {"branch", yard ? json(yard->branch) : Json()}};
  return line.dump();
}

}  // namespace boomwatch
