#include "simulation/demo_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "simulation/scene.h"
#include "simulation/scene_view.h"
#include "simulation/yard/yard_source.h"
#include "sources/indexed_source.h"

namespace boomwatch {
namespace {

constexpr std::size_t frameCount = 600;
constexpr std::size_t framesAnAxis = frameCount / 3;
constexpr double rate = 20.0;

/// From where a load starts, and how far it goes to and fro along each axis in turn.
struct Motion {
  OrientedBox start;
  Eigen::Vector3d swing = Eigen::Vector3d::Zero();  ///< to both sides along x and y
  double reach = 0.0;                               ///< along z, to one side and back

  OrientedBox at(std::size_t frame) const {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(frame % framesAnAxis) /
                        static_cast<double>(framesAnAxis);
    OrientedBox load = start;
    switch (frame / framesAnAxis) {
      case 0:
        load.centre.x() += swing.x() * std::sin(turn);
        break;
      case 1:
        load.centre.y() += swing.y() * std::sin(turn);
        break;
      default:
        load.centre.z() += swing.z() * std::sin(turn) + reach * (1.0 - std::cos(turn)) / 2.0;
    }
    return load;
  }
};

struct Demo {
  Scene scene;
  Motion motion;
};

Demo demoNamed(const std::string& name, const std::string& address) {
  if (name == "floor") {
    // Down to the ground and into it, so that the bar is seen to fill.
    return {floorScene(), {lyingLoad({0.0, 0.0, 5.0}), {1.5, 1.9, 1.5}, 0.0}};
  }
  if (name == "cylinders") {
    const OrientedBox start = cylindersInFront();
    const double reach = cylindersPast().centre.z() - start.centre.z();
    return {cylindersScene(), {start, {1.5, 0.8, 0.0}, reach}};
  }
  if (name == "wall") {
    const OrientedBox start = lyingLoad({0.0, 0.0, 3.8});
    const double reach = wallInside().centre.z() - start.centre.z();
    return {wallScene(), {start, {1.5, 0.8, 0.0}, reach}};
  }
  throw Error(address, "there is no demo '" + name + "'",
              "Give demo:yard, demo:floor, demo:cylinders or demo:wall.");
}

class DemoSource : public IndexedSource {
 public:
  DemoSource(const std::string& name, const std::string& address)
      : IndexedSource(address, frameCount, rate),
        m_demo(demoNamed(name, address)),
        m_view(lookAt(m_demo.scene)) {}

 protected:
  ReadResult read(std::size_t index) override {
    auto frame = std::make_shared<Frame>();
    frame->sequence = index;
    frame->stamp = static_cast<double>(index) / rate;
    const OrientedBox load = m_demo.motion.at(index);
    frame->left = pictureWithLoad(m_view, load, index);
    frame->cloud = m_view.cloud;
    frame->load = load;
    frame->trueDistance = distance(load, m_demo.scene);
    return ok(std::move(frame));
  }

 private:
  Demo m_demo;
  SceneView m_view;
};

}  // namespace

std::unique_ptr<FrameSource> openDemoSource(const std::string& name, const std::string& address) {
  const auto comma = std::min(name.find(','), name.size());
  if (name.substr(0, comma) == "yard") {
    return std::make_unique<YardSource>(name.substr(std::min(name.size(), comma + 1)), address);
  }
  return std::make_unique<DemoSource>(name, address);
}

}  // namespace boomwatch
