#pragma once

#include <cstddef>

namespace boomwatch {

/// Numbers of the median flow. "Kalal": Kalal et al., "Forward-Backward Error: Automatic Detection
/// of Tracking Failures", ICPR 2010. "Chosen": by judgement; not measured one by one.
struct FlowTuning {
  int pyramidLevels = 4;      ///< halvings of the image; chosen, Kalal does not say
  double minMargin = 64.0;    ///< pixels around a box that its search needs at all levels; chosen
  int window = 9;             ///< pixels, side of what is compared around a point; chosen
  int patch = 11;             ///< pixels, side of what must look alike around a point; chosen
  std::size_t minPoints = 6;  ///< points that must be followed; half remain at the end; chosen

  // Which cells of the box move with the target; see FlowCells. All chosen.
  float cellRate = 0.2F;         ///< share of one image in the mean over images
  std::size_t minReliable = 25;  ///< cells of 100 that are asked, however few are reliable
  float mostlyTogether = 0.4F;   ///< share of images from which a cell is reliable
  double clearMotion = 1.5;      ///< pixels a box must move, to tell what stands still
  double togetherShare = 0.5;    ///< of the motion, by which what goes together may differ

  // When a flow is not believed.
  double maxResidual = 10.0;     ///< pixels, median; Kalal, section 3
  double minSimilarity = 0.5;    ///< NCC, median; klt only; chosen
  double minShareInside = 0.25;  ///< of the box, inside the picture; klt only; chosen
};

}  // namespace boomwatch
