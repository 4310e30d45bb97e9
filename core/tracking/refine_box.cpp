#include "tracking/refine_box.h"

#include <array>

#include "tracking/patch_cutter.h"
#include "tracking/tld_tuning.h"

namespace boomwatch {
namespace {

constexpr TldTuning tuning;

using Warp = PatchCutter::Warp;

std::array<Warp, 6> neighboursOf(const Warp& warp, double step) {
  std::array<Warp, 6> neighbours;
  neighbours.fill(warp);
  neighbours[0].shift.x -= step;
  neighbours[1].shift.x += step;
  neighbours[2].shift.y -= step;
  neighbours[3].shift.y += step;
  neighbours[4].scale *= 1.0 - step;
  neighbours[5].scale *= 1.0 + step;
  return neighbours;
}

cv::Rect2d warped(const cv::Rect2d& box, const Warp& warp, double share) {
  const cv::Size2d size = box.size() * (1.0 + share * (warp.scale - 1.0));
  const cv::Point2d centre(box.x + box.width * (0.5 + share * warp.shift.x),
                           box.y + box.height * (0.5 + share * warp.shift.y));
  return {centre - cv::Point2d(size.width, size.height) / 2.0, size};
}

}  // namespace

cv::Rect2d refineBox(const cv::Mat& grey, const cv::Rect2d& box, const ToolClassifier& tool,
                     double share) {
  const PatchCutter cutter(grey, box, tool.patchSize());
  Warp best;
  float most = tool.anchorLikeness(cutter.cut(best));
  for (double step = tuning.firstStep; step >= tuning.lastStep; step /= 2.0) {
    for (int round = 0; round < tuning.roundsPerStep; ++round) {
      const float before = most;
      for (const Warp& warp : neighboursOf(best, step)) {
        const float likeness = tool.anchorLikeness(cutter.cut(warp));
        if (likeness <= most) continue;
        most = likeness;
        best = warp;
      }
      if (most == before) break;
    }
  }
  return most < tuning.minRefined ? box : warped(box, best, share);
}

}  // namespace boomwatch
