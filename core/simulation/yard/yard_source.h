#pragma once

#include <memory>
#include <string>

#include "simulation/yard/yard.h"
#include "simulation/yard/yard_options.h"
#include "simulation/yard/yard_sensor.h"
#include "simulation/yard/yard_truth.h"
#include "sources/indexed_source.h"

namespace boomwatch {

/// A frame of demo:yard and, beside it, all that is known about it.
struct YardFrame {
  FramePtr frame;
  std::shared_ptr<const YardTruth> truth;
};

/// `demo:yard`, or `demo:yard,seed=7,rain=0.5,...` (see YardOptions): a simulated forestry yard
/// with uneven ground, trees, stacks of logs, a wall, somebody who walks about, birds and leaves,
/// and a crane that carries a log through it. 768 x 576 pixels, 20 frames a second, as the camera
/// on the machine's mast sees it; every frame with its load and its true distance.
///
/// The same options give the same bytes, and any frame can be had alone.
class YardSource : public IndexedSource {
 public:
  /// `options` is what follows "yard," in the address. Throws Error naming an option that is
  /// unknown or out of its range.
  explicit YardSource(const std::string& options, const std::string& address = "demo:yard");

  /// Any frame below the count, whatever was read before; any thread.
  YardFrame at(std::size_t index) const;

 protected:
  ReadResult read(std::size_t index) override { return ok(at(index).frame); }

 private:
  YardSource(const YardOptions& options, const std::string& address);
  cv::Rect2d boxAround(const Eigen::Vector3d& toolPoint) const;
  void addBlur(YardShot& shot, double time) const;
  cv::Mat measured(const YardTruth& truth, std::size_t index) const;

  YardOptions m_options;
  Yard m_yard;
  YardSensor m_sensor;
  std::shared_ptr<const StereoRig> m_rig;
};

}  // namespace boomwatch
