#pragma once

#include <cstddef>

namespace boomwatch {

/// Numbers of ColourLayout. Scores are correlations, -1..1. "Chosen": by judgement; not measured
/// one by one.
struct ColourLayoutTuning {
  double cellsOfLongSide = 8.0;  ///< of the tool's box; chosen
  int minCells = 3;              ///< of the short side; chosen
  double scaleStep = 1.2;        ///< ratio of two successive sizes; as in TldTuning
  int scales = 4;                ///< steps to either side of the last size: half to twice
  double minDeviation = 0.5;     ///< Lab, of a cell: below, all is alike; chosen
  int placesOfALevel = 3;        ///< chosen
  std::size_t maxPlaces = 8;     ///< in one image; chosen
  double onTool = 0.4;           ///< overlap from which a place is the tool; chosen
  double samePlace = 0.5;        ///< of the smaller of two boxes, from which they are one; chosen

  double newView = 0.8;          ///< score below which a view is another side; chosen
  double sureView = 0.5;         ///< score above which it is still the tool; chosen
  std::size_t maxViews = 8;      ///< chosen
  std::size_t minObserved = 8;   ///< images before the colours are believed; chosen
  std::size_t maxObserved = 80;  ///< the last images that count; chosen
  double rightShare = 0.9;       ///< of these in which the tool was the place most alike; chosen

  /// How far above the best of the others the threshold lies, towards the tool's own median.
  /// Measured on seven yards in which the tool goes away and comes back turned: with 0.33 it is
  /// found in 22 of 28 cases, with 0.15 in nearly all, with no more boxes while it is away.
  double ownShare = 0.15;
  double minScore = 0.5;  ///< explains a quarter of what is seen; measured: in a picture of noise
                          ///< the best place reached 0.44
  double deniedShare = 0.5;  ///< of the threshold, below which a box is not the tool; chosen
  double margin = 0.02;      ///< of the threshold before the best of the others; chosen
  double lead = 0.05;        ///< of a place before the second; chosen
};

}  // namespace boomwatch
