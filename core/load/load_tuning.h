#pragma once

#include <cstddef>

namespace boomwatch {

/// Numbers of the detection and the following of a load of any shape, a struct an algorithm; those
/// of a log are in LogTuning.
///
/// All are chosen by judgement, and none is measured by itself. Their effect together is:
/// docs/experiments.md, and test_load_poses_slow holds it.
struct LoadTuning {
  /// Standard deviations of the noise within which a measurement agrees with what is expected.
  static constexpr double deviations = 3.0;

  /// DepthPatch.
  struct Patch {
    int finestHalfSide = 75;    ///< cells from the tool to the grid's edge, of a dense cloud
    int coarsestHalfSide = 20;  ///< the same of a sparse one
    double minPerCell = 2.5;  ///< points, below which cells get coarser: finer would tear surfaces
    float nearest = 0.02F;    ///< metres; nothing nearer is measured
    float farthest = 1e6F;    ///< metres; nothing beyond is measured
    int maxThinning = 256;    ///< of the points of a very dense cloud one in so many is looked at
    double logSamples = 4.0;  ///< points a cell, where a log is sought: measured by its outline
    double boxSamples = 8.0;  ///< the same of a box: measured by the cells themselves
  };

  /// dominantPlane().
  struct Plane {
    int hypotheses = 80;       ///< planes through three cells that are tried
    std::size_t looked = 400;  ///< cells by which each is judged
  };

  /// growBody().
  struct Body {
    int seedCells = 2;       ///< around the tool's cell, that may be the tool's too
    double steepness = 3.0;  ///< cells' widths of depth between neighbours: 18 degrees to the view
    std::size_t minPiece = 8;     ///< cells of a piece beside the tool
    double beside = 1.5;          ///< times the tool's radius, within which pieces are sought
    int maxSurfaces = 4;          ///< ground and walls that are taken away
    std::size_t minSurface = 30;  ///< cells
    double surfaceLimit = 0.8;    ///< of reach: what goes on to there goes on beyond
    double surfaceShare = 0.3;    ///< of a piece's cells that lie on its plane
    int sectors = 8;              ///< around the tool
    int farCells = 5;    ///< cells beyond the limit, of a sector into which a plane goes on
    int farSectors = 3;  ///< such sectors of a ground; a load or a boom has two
  };

  /// fitBox().
  struct Box {
    std::size_t minOutside = 30;  ///< cells outside the tool
    double boomLimit = 0.9;       ///< of reach: what goes on to there is boom
    double outermost = 0.005;     ///< of the points, left away on each side of each axis
    double grow = 0.25;        ///< cells' widths that a box is larger on each side than its points
    double minFilled = 0.45;   ///< of what it covers in the picture, seen as the body
    double minOffFace = 0.08;  ///< of the cells, off the largest face: less says nothing of depth
    double minDepth = 0.02;    ///< metres: a nearer corner of a box projects nowhere
    double alongView = 0.1;    ///< weight of the misfit of a size that is not seen across
  };

  /// detectLoad().
  struct Detector {
    double reachShare = 0.6;  ///< of the largest load, from the tool: it is not held in its middle
  };

  /// LoadFollower, an alpha-beta filter.
  struct Follower {
    double positionGain = 0.5;
    double velocityGain = 0.15;
    double spinGain =
        0.05;  ///< what points at the camera seems to turn, and swings little in truth
    int jumpsToBelieve = 3;  ///< frames in a row elsewhere, after which it begins anew
    double jump = 0.3;       ///< metres from where it was expected
    double jumpSpeed = 3.0;  ///< m/s, added for the time that has passed
    double turn = 0.35;      ///< radians
    double turnSpeed = 2.0;  ///< radians a second
    double soon = 0.12;      ///< seconds unseen, after which it goes where the tool goes
    double turning = 0.25;   ///< seconds unseen for which it turns on
  };

  /// HeldTool, whose maxHold other rooms use as well.
  struct Held {
    double gain = 0.1;  ///< of the mean place: one point lies anywhere on what is seen of the tool
  };
};

}  // namespace boomwatch
