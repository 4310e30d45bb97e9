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
/// Depth of a cell: of its nearest point (the thesis's), or of its surface (see CellSurfaces).
enum class CellDepth { Nearest, Surface };
/// Treatment of unobserved space; see ClearanceParameters.
enum class UnknownSpace { Ignore, Show, Solid };
/// Auto: Detected when a tool is tracked or the source gives one, otherwise Scene.
enum class LoadSource { Auto, Scene, Manual, Detected };
enum class LoadShape { Cylinder, Box, Auto };
enum class LoadDimensions { Learnt, Locked };
enum class TrackerKind { Manual, Tld, Cmt, Klt, Csrt };
/// Which point of the tool's box becomes the tool point; see toolPointIn().
enum class ToolPointRule { Right, Near };

/// Matching and checking of a rectified pair (docs/method.md section 2). Pixels.
struct StereoParameters {
  StereoMatcherKind matcher = StereoMatcherKind::Sgbm;
  int minDisparity = 0;
  int disparities = 64;     ///< number of disparities searched; a multiple of 16
  int blockSize = 5;        ///< odd
  int uniqueness = 10;      ///< percent by which the best match must beat the second best
  int consistency = 1;      ///< maximum left/right difference; -1 is off
  int speckleWindow = 100;  ///< minimum size of a connected component, pixels; 0 is off
  int speckleRange = 2;     ///< maximum disparity step inside a connected component
  int preFilterCap = 31;
  /// Mean horizontal gradient, grey levels a pixel, below which an area is not matched; 0 is off.
  double texture = 0.2;
  int average = 1;     ///< frames over which disparity is averaged (static camera); 1 is off
  bool refine = true;  ///< correct row misalignment by turning the right camera
  int smooth = 11;     ///< width of the window over which disparity is averaged; 0 is off
  /// Maximum change of disparity per pixel, pixels; steeper pixels are removed as flying pixels. 0
  /// is off.
  double maxSlope = 0.6;
};

/// Filtering and segmentation (docs/method.md section 5). Metres.
struct FilterParameters {
  std::optional<double> zReprojection;  ///< move every kept point to this z; absent: off
  bool lowPass = false;
  LowPassMethod lowPassMethod = LowPassMethod::Statistical;
  int lowPassNeighbours = 8;       ///< statistical: number of neighbours compared
  double lowPassDeviations = 1.0;  ///< statistical: maximum deviation, standard deviations
  double lowPassRadius = 0.1;      ///< radius: maximum distance of a neighbour
  int lowPassMinimum = 3;          ///< radius: minimum number of neighbours
  double clusterTolerance = 0.1;
  /// Pixels: width of the window that smooths the depth of clouds that no stereo matching of ours
  /// produced; below 3 is off.
  int depthSmooth = 5;
  int clusterMinimum = 20;  ///< points after downsampling; smaller clusters are removed as noise
};

/// The environment model (docs/method.md section 6, Eq. 6-11; see updateCells).
struct ModelParameters {
  double resolution = 0.04;  ///< R, metres a cell
  double probtresh = 0.5;    ///< P_limit
  double pPrior = 0.2;       ///< added by a hit
  double pPost = 0.7;        ///< share left after a frame
  ModelUpdate update = ModelUpdate::Hysteresis;
  double leaveThreshold = 0.1;  ///< hysteresis: at and below it a cell leaves
  double logOddsHit = 0.7;      ///< log-odds: P(occupied) after one hit alone
  double logOddsMiss = 0.4;     ///< log-odds: P(occupied) after one miss alone
  double logOddsLow = 0.12;     ///< log-odds: minimum from which a hit starts
  double logOddsHigh = 0.97;    ///< log-odds: maximum
  int memoryLimit = 1024;       ///< maximum of the model, megabytes
  ModelProjection projection = ModelProjection::Parallel;  ///< see GridGeometry
  CellDepth cellDepth = CellDepth::Surface;
};

/// The search for the nearest obstacle (docs/method.md section 7).
struct ClearanceParameters {
  ClearanceMethod method = ClearanceMethod::Exact;
  int interval = 8;     ///< I: cells between search rays
  int radius = 70;      ///< L: length of a search ray, cells
  double range = 10.0;  ///< metres beyond which `exact` says "nothing in range"
  /// Ignore: unobserved space is free (the thesis's). Show: the result has the observed share, and
  /// below min_observed there is no distance. Solid: unobserved space is an obstacle; see
  /// ExactClearance. Space that boom, tool and load occlude in this frame is exempt.
  UnknownSpace unknownSpace = UnknownSpace::Show;
  /// Metres: components of the model with a smaller diagonal are drawn but ignored.
  double smallestThing = 0.1;
  /// Metres: smaller components are ignored until they are almost certain; see
  /// Components::doubtful. A falling leaf is in no cell for so long. At 0.6 the model would ignore
  /// every bird of the yard, but would report a person who walks below a real camera too late.
  double doubtfulThing = 0.4;
};

/// The parts from which the distance is measured. The smallest distance leads.
struct WatchParameters {
  bool load = true;
  bool tool = false;  ///< points within load_tool_size / 2 of the tool point
  bool boom = false;  ///< the rest of the tool's cluster, in straight segments
};

/// Where each level begins and ends. Metres, seconds.
struct WarningParameters {
  double cautionDistance = 2.0;  ///< at and below
  double warningDistance = 1.0;
  double cautionTime = 2.0;   ///< time to contact, at and below; 0 is off
  double warningTime = 1.0;   ///< as cautionTime
  double deadband = 0.05;     ///< a level ends this much farther away than it begins
  double releaseDelay = 0.5;  ///< how long a lower level must hold before it is shown
};

/// The load as the operator enters it, and settings of its detection. Metres; degrees, because a
/// person types them.
struct LoadParameters {
  LoadSource source = LoadSource::Auto;  ///< Scene: only what the source itself knows
  double x = 0.0, y = 0.0, z = 3.0;
  double sizeX = 2.0, sizeY = 0.3, sizeZ = 0.3;
  double yaw = 0.0, pitch = 0.0, roll = 0.0;
  LoadShape shape = LoadShape::Cylinder;  ///< Auto: a cylinder, or a box where no cylinder fits
  LoadDimensions dimensions = LoadDimensions::Learnt;  ///< Locked: the sizes above
  double learnTime = 2.0;  ///< seconds over which sizes are learnt; see LearntLength
  double maxSize = 5.0;    ///< a longer body is rejected
  double toolSize = 0.8;   ///< diameter of the tool, about the tool point
  double margin = 0.1;     ///< about a detected load; points in it are masked with the load

  /// In the camera frame, metres and radians.
  OrientedBox box() const {
    constexpr double degree = std::numbers::pi / 180.0;
    return {{x, y, z},
            {sizeX, sizeY, sizeZ},
            rotationFromYawPitchRoll(yaw * degree, pitch * degree, roll * degree)};
  }
};

/// Tracking of the tool in the image and in space (docs/method.md section 3).
struct TrackingParameters {
  TrackerKind tracker = TrackerKind::Tld;
  bool learn = true;  ///< keep learning the appearance of the tool; Tld only
  ToolPointRule toolPoint = ToolPointRule::Right;
  double maxToolAge = 0.5;    ///< seconds without a tool point, after which the tool is lost
  double noise = 0.05;        ///< metres: standard deviation of the point as measured
  double acceleration = 2.0;  ///< m/s^2: how quickly the tool may change its velocity
  double maxSpeed = 5.0;      ///< m/s: a point farther away than this allows is rejected
};

/// Limits beyond which there is no distance.
struct ValidityParameters {
  double maxFrameAge = 0.5;  ///< maximum seconds without a frame
  int identicalFrames = 3;   ///< equal frames in a row at which the source is frozen
  double minFill = 0.05;     ///< minimum share of the cloud with a depth
  double sceneMotion = 0.6;  ///< maximum share of picture features that move
  double maxLoadAge = 0.5;   ///< maximum seconds over which an unseen load is extrapolated
  double minObserved = 0.1;  ///< minimum observed share of the load's neighbourhood
};

/// All parameters with their defaults. Replaced as a whole, between two frames.
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

/// Range of the current clearance method around the load, metres.
double searchReach(const Parameters& parameters);

/// Whether that range ends before the caution distance. A search without result is then not clear.
bool searchIsShort(const Parameters& parameters);

}  // namespace boomwatch
