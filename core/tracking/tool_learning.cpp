#include "tracking/tool_learning.h"

#include <numbers>

#include "base/error.h"
#include "tracking/patch_cutter.h"
#include "tracking/tld_tuning.h"

namespace boomwatch {
namespace {

constexpr TldTuning tuning;

constexpr double degree = std::numbers::pi / 180.0;

void learnNegatives(const cv::Rect2d& box, const ScanLevels& levels,
                    const std::vector<Candidate>& candidates, ToolClassifier& tool) {
  for (const Candidate& candidate : candidates) {
    if (overlap(candidate.box, box) >= tuning.elsewhere) continue;
    const cv::Mat patch = levels.patchOf(candidate.window);
    tool.ferns().learn(tool.ferns().codesOf(patch), false);
    if (tool.likeness(patch).relative > tuning.newNegative) tool.learnNegative(patch);
  }
}

}  // namespace

double ToolLearning::within(double limit) {
  return limit * (2.0 * m_random() / static_cast<double>(std::mt19937::max()) - 1.0);
}

void ToolLearning::learnPositives(const cv::Mat& grey, const cv::Rect2d& box, int warps,
                                  double angle, ToolClassifier& tool) {
  const PatchCutter cutter(grey, box, tool.patchSize());
  for (int i = 0; i < warps; ++i) {
    PatchCutter::Warp warp;
    warp.angle = within(angle);
    warp.scale = 1.0 + within(tuning.warpScale);
    warp.shift.x = within(tuning.warpShift);
    warp.shift.y = within(tuning.warpShift);
    tool.ferns().learn(tool.ferns().codesOf(cutter.cut(warp)), true);
  }
}

ToolClassifier ToolLearning::begin(const cv::Mat& grey, const cv::Rect2d& box) {
  ToolModel model;
  model.size = box.size();
  const cv::Mat patch = PatchCutter(grey, box, model.patchSize()).cut();
  if (varianceOf(patch) < tuning.minVariance) {
    throw Error("tool box", "there is nothing in it to follow: all is equal",
                "Draw it around a part with edges or corners.");
  }
  ToolClassifier tool(model);
  tool.learnPositive(patch);
  learnPositives(grey, box, tuning.firstWarps, tuning.firstAngle * degree, tool);
  const ScanLevels levels(grey, box.size(), tool.patchSize(), -tuning.allScales, tuning.allScales);
  for (int scan = 0; scan < tuning.firstScans; ++scan) {
    learnNegatives(box, levels, findCandidates(levels, tool), tool);
  }
  return tool;
}

bool ToolLearning::canLearn(const cv::Mat& grey, const cv::Rect2d& box,
                            const ToolClassifier& tool) {
  const cv::Mat patch = PatchCutter(grey, box, tool.patchSize()).cut();
  return tool.likeness(patch).relative >= tuning.minLikeness &&
         varianceOf(patch) >= tool.minVariance();
}

void ToolLearning::learn(const cv::Mat& grey, const cv::Rect2d& box, const ScanLevels& levels,
                         const std::vector<Candidate>& candidates, ToolClassifier& tool) {
  learnPositives(grey, box, tuning.laterWarps, tuning.laterAngle * degree, tool);
  const cv::Mat patch = PatchCutter(grey, box, tool.patchSize()).cut();
  if (tool.likeness(patch).relative < tuning.newPositive) tool.learnPositive(patch);
  learnNegatives(box, levels, candidates, tool);
}

}  // namespace boomwatch
