#include "lab/experiments/yard_plan.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>

namespace boomwatch {
namespace {

constexpr std::size_t atATime = 2;

struct Work {
  const YardPlan& plan;
  std::vector<std::vector<ChainRun>> runs;  ///< a yard each
  std::atomic<std::size_t> nextYard{0};
  std::atomic<std::size_t> framesDone{0};
  std::atomic<bool> stopped{false};
};

bool needsPictures(const YardPlan& plan) {
  return std::ranges::any_of(plan.stages, [](const YardPlan::Stage& stage) {
    return stage.kind == ChainKind::Stereo || stage.kind == ChainKind::Everything;
  });
}

/// All stages over one yard.
std::vector<ChainRun> runYard(std::uint64_t seed, Work& work) {
  const YardPlan& plan = work.plan;
  // A pair of pictures takes twice as long to paint.
  const std::string options = "path=random,seed=" + std::to_string(seed) +
                              ",frames=" + std::to_string(plan.frames) +
                              (needsPictures(plan) ? "" : ",as=cloud");
  const YardSource source(options);
  std::vector<std::unique_ptr<ChainStage>> stages;
  for (const auto& stage : plan.stages) {
    stages.push_back(std::make_unique<ChainStage>(stage.kind, stage.parameters, seed));
  }
  YardFrame before;
  for (std::size_t k = 0; k < plan.frames && !work.stopped; ++k) {
    const YardFrame shown = source.at(k);
    const ChainFrame truth = truthOf(shown, before);
    for (const auto& stage : stages) stage->process(shown, truth);
    before = shown;
    ++work.framesDone;
  }
  std::vector<ChainRun> runs;
  for (const auto& stage : stages) runs.push_back({stage->kind(), seed, stage->frames()});
  return runs;
}

void runSome(Work& work) {
  for (std::size_t k = work.nextYard++; k < work.plan.yards && !work.stopped; k = work.nextYard++) {
    try {
      work.runs[k] = runYard(work.plan.firstSeed + k, work);
    } catch (...) {
      work.stopped = true;
      throw;
    }
  }
}

}  // namespace

std::optional<std::vector<ChainRun>> runYards(const YardPlan& plan,
                                              const ExperimentProgress& progress) {
  using namespace std::chrono_literals;
  Work work{plan, std::vector<std::vector<ChainRun>>(plan.yards)};
  std::vector<std::future<void>> workers;
  for (std::size_t k = 0; k < std::min(atATime, plan.yards); ++k) {
    workers.push_back(std::async(std::launch::async, [&work] { runSome(work); }));
  }
  const auto all = static_cast<double>(std::max<std::size_t>(1, plan.yards * plan.frames));
  bool wanted = true;
  for (auto& worker : workers) {
    while (worker.wait_for(100ms) == std::future_status::timeout) {
      wanted = wanted && progress(static_cast<double>(work.framesDone) / all);
      if (!wanted) work.stopped = true;
    }
  }
  for (auto& worker : workers) worker.get();
  if (!wanted || !progress(1.0)) return std::nullopt;
  std::vector<ChainRun> runs;
  for (auto& yard : work.runs) std::ranges::move(yard, std::back_inserter(runs));
  return runs;
}

}  // namespace boomwatch
