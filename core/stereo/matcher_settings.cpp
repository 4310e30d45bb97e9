#include "stereo/matcher_settings.h"

#include <string>

#include "base/error.h"
#include "parameters/parameter_range.h"
#include "parameters/parameter_text.h"

namespace boomwatch {
namespace {

void require(bool condition, std::string_view key, const std::string& what,
             const std::string& remedy) {
  if (!condition) throw Error("parameter '" + std::string(key) + "'", what, remedy);
}

/// Outside of them OpenCV divides by zero or overflows.
void requireRanges(const StereoParameters& stereo) {
  Parameters all;
  all.stereo = stereo;
  for (const ParameterInfo& info : parameterTable()) {
    if (!info.key.starts_with("stereo_")) continue;
    const ParameterValue value = info.get(all);
    require(inRange(info, value), info.key,
            formatValue(info, value) + " is not among " + rangeText(info),
            "Set a value in that range.");
  }
}

}  // namespace

void requireMatcherSettings(const StereoParameters& stereo) {
  // OpenCV computes 16 disparities at a time, and bm compares blocks of at least 5 pixels.
  constexpr int disparityStep = 16, minBmBlock = 5;
  constexpr int maxSgbmBlock = 15;  // above it the 16-bit costs of sgbm overflow
  requireRanges(stereo);
  require(stereo.disparities % disparityStep == 0, "stereo_disparities",
          std::to_string(stereo.disparities) + " is not a multiple of 16", "Set a multiple of 16.");
  require(stereo.blockSize % 2 == 1, "stereo_block_size",
          std::to_string(stereo.blockSize) + " is not odd", "Set an odd number.");
  const bool isBm = stereo.matcher == StereoMatcherKind::Bm;
  require(!isBm || stereo.blockSize >= minBmBlock, "stereo_block_size", "bm needs at least 5",
          "Set 5 or more.");
  require(isBm || stereo.blockSize <= maxSgbmBlock, "stereo_block_size", "sgbm takes at most 15",
          "Set 15 or less.");
}

}  // namespace boomwatch
