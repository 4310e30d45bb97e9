#pragma once

#include <array>
#include <cstddef>

namespace boomwatch {

/// Numbers of the tracker of keypoints. "Published": Nebehay and Pflugfelder, WACV 2014 and CVPR
/// 2015. "Chosen": by judgement; not measured one by one.
struct CmtTuning {
  // Corners.
  int cornerThreshold = 15;  ///< grey levels, of an image with full contrast; chosen
  std::array<double, 3> sizes{1.0, 1.5, 2.25};  ///< times smaller, at which corners are sought
  int cellsAcross = 16;     ///< of the image; the strongest corners of each are kept; chosen
  int cellsDown = 12;       ///< chosen
  int keptInCell = 2;       ///< chosen
  int denseCells = 6;       ///< across and down the dense part; chosen
  int keptInDenseCell = 4;  ///< chosen
  int border = 32;          ///< pixels around a corner that BRISK may read

  // Matching.
  double matchRatio = 0.8;  ///< of a match's distance to the next best's; published
  int maxDistance = 128;    ///< bits of 512 that may differ; published as a quarter
  double sameSpot = 6.0;    ///< pixels within which two corners are no rivals; chosen
  int rivals = 4;           ///< matches looked at for a rival that lies elsewhere; chosen
  double maxReturn = 3.0;   ///< pixels, forward-backward error; chosen
  int window = 15;          ///< pixels, side of what is compared around a point; chosen

  // Consensus.
  double maxReach = 20.0;    ///< pixels between votes of one cluster; published
  double reachShare = 0.3;   ///< of the box's side, at most: less for small targets; chosen
  double minApart = 1.0;     ///< pixels in the first image: closer pairs say nothing; chosen
  double minApartNow = 0.5;  ///< pixels in this image; chosen

  // When the target is seen.
  std::size_t minModelPoints = 6;  ///< to begin with; chosen
  double minShare = 0.05;          ///< of the points; chosen, published is 0.1 of fewer points
  std::size_t minAgreeing = 5;     ///< points; chosen
  double minSurvival = 0.25;  ///< of the points of the image before; chosen: of what has taken the
                              ///< target's place, flow carries some on
  double maxScale = 8.0;      ///< times larger or smaller than at first; chosen
  double grown = 0.25;        ///< of the box, around it, where it may be next; chosen
};

}  // namespace boomwatch
