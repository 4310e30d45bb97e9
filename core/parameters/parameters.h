#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frame/bounds.h"
#include "frame/oriented_box.h"
#include "parameters/model_projection.h"

namespace boomwatch {

enum class StereoMatcherKind { Sgbm, Bm };
enum class LowPassMethod { Statistical, Radius };
enum class ClearanceMethod { Exact, Rays };
enum class ModelUpdate { Thesis, Hysteresis, LogOdds };
/// Where a cell has its surface: at the nearest point (the thesis's), or see CellSurfaces.
enum class CellDepth { Nearest, Surface };
/// What is done about space that was never seen; see ClearanceParameters.
enum class UnknownSpace { Ignore, Show, Solid };
/// Auto: detected where a tool is followed, else what the scene knows.
enum class LoadSource { Auto, Scene, Manual, Detected };
enum class LoadShape { Cylinder, Box, Auto };
enum class LoadDimensions { Learnt, Locked };
enum class TrackerKind { Manual, Tld, Cmt, Klt, Csrt };
/// Where in the tool's box its 3-D point is looked for; see toolPointIn().
enum class ToolPointRule { Right, Near };

/// Matching and checking of a rectified pair (docs/method.md section 2). Pixels.
struct StereoParameters {
  StereoMatcherKind matcher = StereoMatcherKind::Sgbm;
  int minDisparity = 0;
  int disparities = 64;     ///< number of disparities searched; a multiple of 16
  int blockSize = 5;        ///< odd
  int uniqueness = 10;      ///< percent by which the best match must beat the second
  int consistency = 1;      ///< left/right difference allowed; -1 is off
  int speckleWindow = 100;  ///< smallest connected piece kept, pixels; 0 is off
  int speckleRange = 2;     ///< disparity step inside a piece
  int preFilterCap = 31;
  /// Mean horizontal gradient, grey levels a pixel, below which an area is not matched; 0 is off.
  double texture = 0.2;
  int average = 1;     ///< frames of a still camera that a disparity is the mean of; 1 is off
  bool refine = true;  ///< correct the right camera so that the rows of both pictures agree
  int smooth = 11;     ///< width of the neighbourhood that a disparity is the mean of; 0 is off
  /// Change of disparity from pixel to pixel, pixels, above which it is a veil that the matcher has
  /// drawn between a near thing and what is behind it, and goes; 0 is off.
  double maxSlope = 0.6;
};

/// Filtering and segmentation (docs/method.md section 5). Metres.
struct FilterParameters {
  std::optional<double> zReprojection;  ///< move every kept point to this z; absent: off
  bool lowPass = false;
  LowPassMethod lowPassMethod = LowPassMethod::Statistical;
  int lowPassNeighbours = 8;       ///< statistical: neighbours looked at
  double lowPassDeviations = 1.0;  ///< statistical: standard deviations allowed
  double lowPassRadius = 0.1;      ///< radius: how far a neighbour may be
  int lowPassMinimum = 3;          ///< radius: neighbours a point must have
  double clusterTolerance = 0.1;
  /// Pixels: width of the neighbourhood over which the depth of a cloud that comes as one (not from
  /// our own matching, which has its own) is smoothed as far as it is noisy; below 3 it is not.
  int depthSmooth = 5;
  int clusterMinimum = 20;  ///< points after downsampling; smaller clusters are noise
};

/// The environment model (docs/method.md section 6, Eq. 6-11; see updateCells).
struct ModelParameters {
  double resolution = 0.04;  ///< R, metres a cell
  double probtresh = 0.5;    ///< P_limit
  double pPrior = 0.2;       ///< added by a hit
  double pPost = 0.7;        ///< what is left after a frame
  ModelUpdate update = ModelUpdate::Hysteresis;
  double leaveThreshold = 0.1;  ///< hysteresis: at and below it a cell leaves
  double logOddsHit = 0.7;      ///< log-odds: P(occupied) that a measurement alone would give
  double logOddsMiss = 0.4;     ///< log-odds: P(occupied) that a miss alone would give
  double logOddsLow = 0.12;     ///< log-odds: the least that a hit starts from
  double logOddsHigh = 0.97;    ///< log-odds: the most that hits lead to
  int memoryLimit = 1024;       ///< megabytes the model may take
  ModelProjection projection = ModelProjection::Parallel;  ///< see GridGeometry
  CellDepth cellDepth = CellDepth::Surface;
};

/// The search for the nearest thing (docs/method.md section 7).
struct ClearanceParameters {
  ClearanceMethod method = ClearanceMethod::Exact;
  int interval = 8;     ///< I: cells between search rays
  int radius = 70;      ///< L: length of a search ray, cells
  double range = 10.0;  ///< metres beyond which `exact` says "nothing in range"
  /// Ignore: as if it were free, however little was seen (the thesis's). Show: its share is part of
  /// the result, and below min_observed there is no distance. Solid: as an obstacle; see
  /// ExactClearance. What boom, tool and load hide at the moment is exempt.
  UnknownSpace unknownSpace = UnknownSpace::Show;
  /// Metres: pieces of the model that are smaller from corner to corner are drawn, but do not
  /// count.
  double smallestThing = 0.1;
  /// Metres: pieces that are smaller than this count only when they are as good as certain; see
  /// Components::doubtful. A falling leaf is in no cell for so long. Not more: at 0.6, which would
  /// let every bird of the yard pass, somebody who walks below a real camera counts too late.
  double doubtfulThing = 0.4;
};

/// From what the distance is watched; the smallest leads.
struct WatchParameters {
  bool load = true;
  bool tool = false;  ///< what is within load_tool_size / 2 of the tool point
  bool boom = false;  ///< the rest of the tool's cluster, in segments
};

/// When each level begins, and when it ends. Metres, seconds.
struct WarningParameters {
  double cautionDistance = 2.0;  ///< at and below
  double warningDistance = 1.0;
  double cautionTime = 2.0;   ///< to contact, at and below; 0 is off
  double warningTime = 1.0;   ///< as cautionTime
  double deadband = 0.05;     ///< a level ends this much farther away than it begins
  double releaseDelay = 0.5;  ///< for so long a lower level must do before it is shown
};

/// The load as the operator describes it, or how it is detected. Metres, degrees (this is what a
/// person types).
struct LoadParameters {
  LoadSource source = LoadSource::Auto;  ///< Scene: only what the source itself knows
  double x = 0.0, y = 0.0, z = 3.0;
  double sizeX = 2.0, sizeY = 0.3, sizeZ = 0.3;
  double yaw = 0.0, pitch = 0.0, roll = 0.0;
  LoadShape shape = LoadShape::Cylinder;  ///< Auto: a cylinder, or a box where there is none
  LoadDimensions dimensions = LoadDimensions::Learnt;  ///< Locked: the sizes above
  double learnTime = 2.0;  ///< seconds over which sizes are learnt; see LearntLength
  double maxSize = 5.0;    ///< what is longer is no load
  double toolSize = 0.8;   ///< diameter, about the tool point, of what is the tool itself
  double margin = 0.1;     ///< about a detected load, in which points are taken out with it

  /// In the camera frame, metres and radians.
  OrientedBox box() const {
    constexpr double degree = std::numbers::pi / 180.0;
    return {{x, y, z},
            {sizeX, sizeY, sizeZ},
            rotationFromYawPitchRoll(yaw * degree, pitch * degree, roll * degree)};
  }
};

/// Following the tool in the image and in space (docs/method.md section 3).
struct TrackingParameters {
  TrackerKind tracker = TrackerKind::Tld;
  bool learn = true;  ///< where the tracker can: go on learning what the tool looks like
  ToolPointRule toolPoint = ToolPointRule::Right;
  double maxToolAge = 0.5;    ///< seconds without the tool's point after which it counts as lost
  double noise = 0.05;        ///< metres: standard deviation of the point as measured
  double acceleration = 2.0;  ///< m/s^2: how quickly the tool changes its velocity
  double maxSpeed = 5.0;      ///< m/s: what is further away than this allows is not the tool
};

/// When the chain is not to be trusted.
struct ValidityParameters {
  double maxFrameAge = 0.5;  ///< seconds without a frame
  int identicalFrames = 3;   ///< this many equal frames in a row mean a frozen source
  double minFill = 0.05;     ///< share of the cloud that must be measured
  double sceneMotion = 0.6;  ///< share of picture features that move: the camera moves
  double maxLoadAge = 0.5;   ///< seconds for which a load that is not seen is taken to be there
  double minObserved = 0.1;  ///< share of the load's neighbourhood that must have been observed
};

/// Everything that can be tuned, with its defaults. Swapped whole between two frames.
struct Parameters {
  Bounds bounds;
  FilterParameters filter;
  ModelParameters model;
  ClearanceParameters clearance;
  WatchParameters watch;
  WarningParameters warning;
  StereoParameters stereo;
  LoadParameters load;
  TrackingParameters tracking;
  ValidityParameters validity;
};

/// How far from the load the clearance method in force looks, metres.
double searchReach(const Parameters& parameters);

/// Whether that is less than the caution distance: then nothing found does not mean clear.
bool searchIsShort(const Parameters& parameters);

}  // namespace boomwatch
