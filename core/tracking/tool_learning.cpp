#include "tracking/tool_learning.h"

#include <numbers>

#include "base/error.h"
#include "tracking/patch_cutter.h"

namespace boomwatch {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
// The papers' warps for the ferns: many from the first image, few from each later one.
constexpr int firstWarps = 200;
constexpr double firstAngle = 10.0 * degree;
constexpr int laterWarps = 20;
constexpr double laterAngle = 5.0 * degree;
// Half of what lies between two scanning windows and between two scales.
constexpr double warpShift = 0.07;
constexpr double warpScale = 0.1;
// How alike a patch may be and still be new: of the tool, and of what is not.
constexpr float newPositive = 0.75F;
constexpr float newNegative = 0.5F;
constexpr float minLikeness = 0.5F;
// A window that overlaps less with the tool is not the tool.
constexpr double elsewhere = 0.2;
constexpr int firstScans = 4;
constexpr int firstScales = 8;
constexpr double minVariance = 0.25;  // of 8-bit values: below, all are equal

void learnNegatives(const cv::Rect2d& box, const ScanLevels& levels,
                    const std::vector<Candidate>& candidates, ToolClassifier& tool) {
  for (const Candidate& candidate : candidates) {
    if (overlap(candidate.box, box) >= elsewhere) continue;
    const cv::Mat patch = levels.patchOf(candidate.window);
    tool.ferns().learn(tool.ferns().codesOf(patch), false);
    if (tool.likeness(patch).relative > newNegative) tool.learnNegative(patch);
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
    warp.scale = 1.0 + within(warpScale);
    warp.shift.x = within(warpShift);
    warp.shift.y = within(warpShift);
    tool.ferns().learn(tool.ferns().codesOf(cutter.cut(warp)), true);
  }
}

ToolClassifier ToolLearning::begin(const cv::Mat& grey, const cv::Rect2d& box) {
  ToolModel model;
  model.size = box.size();
  const cv::Mat patch = PatchCutter(grey, box, model.patchSize()).cut();
  if (varianceOf(patch) < minVariance) {
    throw Error("tool box", "there is nothing in it to follow: all is equal",
                "Draw it around a part with edges or corners.");
  }
  ToolClassifier tool(model);
  tool.learnPositive(patch);
  learnPositives(grey, box, firstWarps, firstAngle, tool);
  const ScanLevels levels(grey, box.size(), tool.patchSize(), -firstScales, firstScales);
  for (int scan = 0; scan < firstScans; ++scan) {
    learnNegatives(box, levels, findCandidates(levels, tool), tool);
  }
  return tool;
}

bool ToolLearning::canLearn(const cv::Mat& grey, const cv::Rect2d& box,
                            const ToolClassifier& tool) {
  const cv::Mat patch = PatchCutter(grey, box, tool.patchSize()).cut();
  return tool.likeness(patch).relative >= minLikeness && varianceOf(patch) >= tool.minVariance();
}

void ToolLearning::learn(const cv::Mat& grey, const cv::Rect2d& box, const ScanLevels& levels,
                         const std::vector<Candidate>& candidates, ToolClassifier& tool) {
  learnPositives(grey, box, laterWarps, laterAngle, tool);
  const cv::Mat patch = PatchCutter(grey, box, tool.patchSize()).cut();
  if (tool.likeness(patch).relative < newPositive) tool.learnPositive(patch);
  learnNegatives(box, levels, candidates, tool);
}

}  // namespace boomwatch
