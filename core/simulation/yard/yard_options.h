#pragma once

#include <cstdint>
#include <string>

#include "simulation/yard/crane_path.h"

namespace boomwatch {

/// As what the yard is seen.
enum class YardView {
  Stereo,  ///< a pair of pictures with its calibration
  Depth,   ///< a picture and noisy depth, in millimetres, as a depth camera gives it
  Cloud,   ///< a picture and the exact surface points
};

/// What can be chosen behind `demo:yard`.
struct YardOptions {
  std::uint64_t seed = 1;    ///< another one: another yard, another path, other weather
  std::size_t frames = 600;  ///< 20 a second
  YardView as = YardView::Stereo;
  YardPath path = YardPath::Scripted;
  double noise = 2.0;       ///< of the pictures: standard deviation, grey levels
  double exposure = 0.0;    ///< how far it swings to both sides, stops (1: half to double)
  double blur = 0.0;        ///< share of the time between two frames that the shutter is open
  double rain = 0.0;        ///< 0: none; 1: a downpour
  double depthNoise = 0.0;  ///< of depth and cloud: standard deviation, pixels of disparity
  bool person = true;
  bool clutter = true;  ///< birds, falling leaves, swaying branches
};

/// Reads "seed=7,frames=600,as=depth": any of the options, each once, in any order. Throws Error
/// naming `address`, the option and its range.
YardOptions parseYardOptions(const std::string& text, const std::string& address);

/// One line an option, with its range and default: for --help. English.
std::string yardOptionsHelp();

}  // namespace boomwatch
