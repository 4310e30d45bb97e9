#pragma once

#include <array>
#include <cstddef>

namespace boomwatch {

/// Numbers of LastAppearance. "Chosen": by judgement; not measured one by one.
struct LastAppearanceTuning {
  double rim = 0.25;         ///< of the box, on each side; chosen
  double side = 24.0;        ///< pixels of the patch, about; chosen
  double minShown = 0.9;     ///< of the tool inside the picture: half a tool is like many objects
  int minPatch = 8;          ///< pixels; chosen
  double minVariance = 1.0;  ///< grey levels squared: less looks like everything; chosen
  std::array<double, 5> sizes{1.0, 0.9, 1.11, 0.8, 1.23};  ///< of the last one, tried; chosen

  /// Correlation. Measured on Kalal's, OTB's and OpenCV's sequences with the target taken out for a
  /// while: 0.65 to 0.95 where it comes back. Without it up to 0.8 with the rim, but below 0.6
  /// without the rim where another object is in the same place.
  double alike = 0.65;
  double lead = 0.05;      ///< before other places and before all since it was lost; measured so
  double samePlace = 0.5;  ///< overlap of two images' places; chosen
  std::size_t comesBackIn = 8;  ///< images from behind what covered it; chosen
};

}  // namespace boomwatch
