#include "pipeline/parameter_checks.h"

#include <cmath>
#include <locale>
#include <sstream>

#include "base/error.h"
#include "environment/cell_update.h"
#include "environment/grid_geometry.h"
#include "stereo/matcher_settings.h"

namespace boomwatch {
namespace {

std::string format(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

void requireOrder(const char* lowKey, double low, const char* highKey, double high) {
  if (low < high) return;
  throw Error("parameters '" + std::string(lowKey) + "' and '" + highKey + "'",
              format(low) + " is not below " + format(high),
              "Set " + std::string(lowKey) + " below " + highKey + ".");
}

void requireModelFits(const Parameters& p) {
  // In doubles: the integers of GridGeometry can overflow here.
  const auto cells = [&](double low, double high) {
    return std::floor((high - low) / p.model.resolution);
  };
  const GridGeometry::Plane plane = GridGeometry::planeOf(p.bounds, p.model.projection);
  const double columns = cells(plane.left, plane.right);
  const double rows = cells(plane.top, plane.bottom);
  if (!(columns >= 1 && rows >= 1)) {  // a NaN is refused as well
    throw Error("parameter 'resolution'", "a cell is larger than the bounds",
                "Lower resolution or widen the bounds.");
  }
  const double megabytes = columns * rows * GridGeometry::bytesPerCell / 1e6;
  if (!(megabytes <= p.model.memoryLimit)) {
    throw Error("parameter 'resolution'",
                "the model would take " + format(std::round(megabytes)) +
                    " MB, more than memory_limit (" + std::to_string(p.model.memoryLimit) + " MB)",
                "Raise resolution, narrow the bounds or raise memory_limit.");
  }
}

void requireTimesInOrder(const WarningParameters& warning) {
  if (warning.cautionTime == 0.0 || warning.warningTime <= warning.cautionTime) return;
  throw Error("parameters 'warning_time' and 'caution_time'",
              format(warning.warningTime) + " is more than " + format(warning.cautionTime),
              "Set warning_time to caution_time or less, or caution_time to 0 (off).");
}

void requireThresholdsApart(const ModelParameters& model) {
  if (model.update != ModelUpdate::Hysteresis) return;
  requireOrder("leave_threshold", model.leaveThreshold, "probtresh", model.probtresh);
}

void requireRaysForward(const Parameters& p) {
  if (p.model.projection != ModelProjection::Perspective) return;
  if (p.bounds.zMin < 0.0) {
    throw Error("parameter 'model_projection'",
                "a perspective model begins at the camera, but z_min is " + format(p.bounds.zMin),
                "Set z_min to 0 or more, or model_projection to parallel.");
  }
  if (p.clearance.method == ClearanceMethod::Rays) {
    throw Error("parameters 'model_projection' and 'clearance_method'",
                "search rays need a parallel model",
                "Set clearance_method to exact, or model_projection to parallel.");
  }
}

void requireSomethingWatched(const WatchParameters& watch) {
  if (watch.load || watch.tool || watch.boom) return;
  throw Error("parameters 'watch_load', 'watch_tool' and 'watch_boom'", "all of them are off",
              "Switch at least one of them on.");
}

void requireSolidIsExact(const ClearanceParameters& clearance) {
  if (clearance.unknownSpace != UnknownSpace::Solid) return;
  if (clearance.method == ClearanceMethod::Exact) return;
  throw Error("parameters 'unknown_space' and 'clearance_method'",
              "search rays do not find unobserved space",
              "Set clearance_method to exact, or unknown_space to show.");
}

/// Outside the bounds the model would take every point for one that the camera sees through.
void requireReprojectionInside(const Parameters& p) {
  const auto& z = p.filter.zReprojection;
  if (!z || (*z >= p.bounds.zMin && *z < p.bounds.zMax)) return;
  throw Error("parameter 'z_reprojection'",
              format(*z) + " m is not between z_min (" + format(p.bounds.zMin) + ") and z_max (" +
                  format(p.bounds.zMax) + ")",
              "Set a depth inside the bounds, or off.");
}

}  // namespace

void validate(const Parameters& p) {
  requireOrder("x_min", p.bounds.xMin, "x_max", p.bounds.xMax);
  requireOrder("y_min", p.bounds.yMin, "y_max", p.bounds.yMax);
  requireOrder("z_min", p.bounds.zMin, "z_max", p.bounds.zMax);
  requireOrder("warning_distance", p.warning.warningDistance, "caution_distance",
               p.warning.cautionDistance);
  requireTimesInOrder(p.warning);
  requireRaysForward(p);
  requireSolidIsExact(p.clearance);
  requireSomethingWatched(p.watch);
  requireModelFits(p);
  requireThresholdsApart(p.model);
  requireReprojectionInside(p);
  requireMatcherSettings(p.stereo);
}

std::vector<ParameterWarning> warningsFor(const Parameters& p) {
  std::vector<ParameterWarning> warnings;
  if (!framesToEnter(p.model)) {
    const bool odds = p.model.update == ModelUpdate::LogOdds;
    warnings.push_back({ParameterRemark::NothingEnters, "probtresh",
                        std::string("probtresh is not below ") +
                            (odds ? "log_odds_high" : "p_prior / (1 - p_post)") +
                            ", the maximum probability of a cell: no object enters the model. "
                            "Lower probtresh"});
  }
  if (!letsGo(p.model)) {
    warnings.push_back({ParameterRemark::NothingLeaves, "probtresh",
                        "probtresh is so low that a cell stays occupied even when the camera sees "
                        "through it: no object leaves the model. Raise probtresh"});
  }
  // The window shows "nothing in range" as clear, so the search must reach the caution distance.
  if (searchIsShort(p)) {
    const bool rays = p.clearance.method == ClearanceMethod::Rays;
    warnings.push_back({ParameterRemark::SearchTooShort, rays ? "radius" : "range",
                        "the search ends at " + format(searchReach(p)) +
                            " m, before caution_distance (" + format(p.warning.cautionDistance) +
                            " m): if it finds no obstacle, there is no distance. Raise " +
                            (rays ? "radius" : "range")});
  }
  return warnings;
}

}  // namespace boomwatch
