#include "pipeline/parameters.h"

#include <cmath>
#include <locale>
#include <sstream>

#include "environment/grid.h"
#include "frame/error.h"

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
  const double columns = std::floor((p.bounds.xMax - p.bounds.xMin) / p.model.resolution);
  const double rows = std::floor((p.bounds.yMax - p.bounds.yMin) / p.model.resolution);
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

}  // namespace

void validate(const Parameters& p) {
  requireOrder("x_min", p.bounds.xMin, "x_max", p.bounds.xMax);
  requireOrder("y_min", p.bounds.yMin, "y_max", p.bounds.yMax);
  requireOrder("z_min", p.bounds.zMin, "z_max", p.bounds.zMax);
  requireOrder("warning_distance", p.warning.warningDistance, "caution_distance",
               p.warning.cautionDistance);
  requireModelFits(p);
  if (p.stereo.disparities % 16 != 0) {
    throw Error("parameter 'stereo_disparities'", "not a multiple of 16", "Round it to one.");
  }
  if (p.stereo.blockSize % 2 == 0) {
    throw Error("parameter 'stereo_block_size'", "not odd", "Add one.");
  }
  if (p.stereo.matcher == StereoMatcherKind::Bm && p.stereo.blockSize < 5) {
    throw Error("parameter 'stereo_block_size'", "bm needs at least 5", "Set 5 or more.");
  }
  if (p.stereo.matcher == StereoMatcherKind::Sgbm && p.stereo.blockSize > 15) {
    throw Error("parameter 'stereo_block_size'", "sgbm takes at most 15", "Set 15 or less.");
  }
}

std::vector<ParameterWarning> warningsFor(const Parameters& p) {
  std::vector<ParameterWarning> warnings;
  if (p.model.probtresh >= p.model.pPrior / (1.0 - p.model.pPost)) {
    warnings.push_back({"probtresh",
                        "probtresh is at or above p_prior / (1 - p_post), the highest probability "
                        "a cell can reach: nothing enters the model"});
  }
  return warnings;
}

}  // namespace boomwatch
