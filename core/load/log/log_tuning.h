#pragma once

#include <array>
#include <cstddef>

namespace boomwatch {

/// Numbers of the detection and the following of a log, a struct an algorithm.
///
/// All are chosen by judgement, and none is measured by itself. Their effect together is:
/// docs/experiments.md, and test_load_poses_slow holds it.
struct LogTuning {
  /// Standard deviations of a point's noise within which it belongs to a surface.
  static constexpr double gate = 3.5;

  /// findLog() and followLog().
  struct Find {
    double armCells = 4.0;     ///< cells that a log reaches out of the tool on each side
    double thickest = 0.25;    ///< diameter, of the largest size of a load
    double thinnest = 0.03;    ///< radius, metres
    double above = 0.15;       ///< metres by which a grapple is longer than it is wide
    double minShown = 0.5;     ///< of that arm, seen
    double nearMiddle = 0.33;  ///< of the length, the shorter arm; a boom is held at its end
    double toolDepth = 0.2;    ///< metres from the tool point to the tool's middle
    double deep = 0.35;        ///< metres by which a grapple is deeper than a line in it
    double open = 0.3;         ///< metres of background that a grapple may show
    double onwards = 0.4;      ///< metres beyond an end or beside it, where a boom would go on
    double onBeside = 0.2;     ///< metres beside the log, where it goes on past an end
    double onNearest = 0.08;   ///< metres within which it is the log still
    int stray = 8;             ///< cells there that do not count
    double endWithin = 0.1;    ///< metres to which the place of an end is known
    double endPitches = 3.0;   ///< spacings of the samples, added to that
    double thickShare = 0.3;   ///< by which radii of one log may differ
    int maxTried = 7;          ///< lines along which a log is fitted
    double logAspect = 1.5;    ///< of length to diameter, above which a box is a log's
    double minSine = 0.1;      ///< of axis and view, in divisions by it
  };

  /// followLog(): from the expected pose.
  struct Follow {
    double aside = 0.3;    ///< metres across the axis
    double turned = 0.94;  ///< cosine: 20 degrees
    double endOn = 0.12;   ///< radians between axis and view; see CylinderLimits
    double thinner = 0.7;  ///< of the radius
    double thicker = 1.4;  ///< of the radius
    /// Radians towards the camera or away: of its pose that is seen least.
    std::array<double, 5> tilts{0.0, 0.08, -0.08, 0.16, -0.16};
  };

  /// AxisSearch.
  struct Axis {
    std::size_t maxSpots = 2500;  ///< cells of the body that are looked at
    double deviations = 2.5;      ///< of a cell's noise, within which it lies on a line
    double thickness = 0.04;      ///< metres, added to that
    int directions = 48;          ///< of the fan: 3.75 degrees apart
    double laneWidth = 2.0;       ///< cells
    int draws = 12;               ///< lines tried in a lane
    std::size_t minMembers = 3;   ///< spots on either side
    double middle = 2.0;          ///< cells from the tool that are surely the tool's
    double sameDirection = 0.97;  ///< cosine: 14 degrees
    double samePlace = 0.3;       ///< metres
    int maxGap = 4;               ///< bins without a spot inside an arm
    double binCells = 2.0;        ///< cells a bin
    double longerArm = 0.1;       ///< weight of a spot on the longer arm
  };

  /// cutStrip().
  struct Strip {
    double steep = 0.08;       ///< metres of depth from a sample to the next
    int strays = 2;            ///< samples in a row elsewhere, after which a slice ends
    double meanGain = 0.3;     ///< of a sample, in the running depth along a slice
    double gap = 3.5;          ///< spacings of the samples: more is a gap
    double deep = 0.15;        ///< metres of depth from the line to what is followed
    int draws = 150;           ///< outlines tried
    double taper = 0.35;       ///< by which two widths of a log may differ
    double drawsApart = 0.15;  ///< of the strip, between the two slices of a draw
    double maxWidth = 2.2;     ///< of the largest radius, the width of a slice
    double minWidth = 2.0;     ///< of the smallest radius
    double outlinePitches =
        2.0;  ///< spacings of the samples within which a slice ends on an outline
    double outlineMetres = 0.015;  ///< added to that
    double parts = 5.0;            ///< of a slice, a mean each
    std::size_t minSurface = 20;   ///< means
    std::size_t minSlices = 5;
    int rounds = 6;  ///< of the robust line
  };

  /// fitCylinder().
  struct Fit {
    double roughness = 0.01;   ///< metres by which bark is no cylinder
    double shared = 0.5;       ///< share of a point's noise that its neighbours have as well
    double soft = 4.0;         ///< squared deviations beyond whose root a residual pulls less
    double minAspect = 1.5;    ///< of length to diameter; what is stubbier has no axis
    double aside = 0.1;        ///< metres, deviation of what is expected: across the view
    double deep = 0.15;        ///< metres, in depth
    double thick = 0.05;       ///< of the radius
    int iterations = 8;        ///< of Levenberg-Marquardt
    double within = 3.0;       ///< deviations of what agrees
    double minShare = 0.6;     ///< of depths and of each edge, that agree
    int minCount = 5;          ///< depths, and ends on each edge
    double pastEnd = 0.35;     ///< metres past an expected end that are looked at, at least
    double pastCells = 4.0;    ///< cells, the same; a long way along what points at the camera
    double minSine = 0.1;      ///< of axis and view, in divisions by it
    int rounds = 2;            ///< each begins on the surface that the one before found
    double minFilled = 0.7;    ///< of what is not covered between the ends, seen as cylinder
    double minOutlined = 0.4;  ///< of the slices, that fit the outline
    double room = 0.1;         ///< metres around what is expected
    double halfWidth = 1.6;    ///< radii from the line that are looked at
  };

  /// findEnds().
  struct Ends {
    double roughness = 0.03;   ///< metres by which a log is no cylinder
    double slack = 0.05;       ///< metres by which a whole slice may lie behind it
    double shared = 0.3;       ///< share of a point's noise that its neighbours have as well
    double inner = 0.6;        ///< of the half width that is looked at; an edge has little depth
    double minSeen = 0.3;      ///< of the samples that have room in a slice
    double meanWithin = 3.0;   ///< deviations of a slice's mean
    double endCells = 1.5;     ///< cells without the log, after which it has ended
    double emptyCells = 7.0;   ///< cells without anything, after which it has ended
    int beforeFirst = 4;       ///< times endCells, before any of the arm was seen
    int atBorder = 2;          ///< slices without the log, just before the picture's border
    int flatSteps = 40;        ///< places of a flat end that are tried
    double flatRange = 0.4;    ///< metres over which they lie
    double facing = -0.1;      ///< cosine of a flat end that faces the camera
    double flatOutlier = 9.0;  ///< squared deviations, at most, of one slice
  };

  /// LearntLength.
  struct Length {
    double minCrosswise = 0.2;  ///< sine: below, one view is no better than another
    double clearly = 1.2;       ///< times the sine of the worst view: noise must not choose
  };
};

}  // namespace boomwatch
