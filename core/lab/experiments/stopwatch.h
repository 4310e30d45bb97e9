#pragma once

#include <chrono>
#include <vector>

#include "lab/experiments/statistics.h"

namespace boomwatch {

/// Milliseconds that one call takes.
template <class Work>
double millisecondsOf(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const auto end = std::chrono::steady_clock::now();
  return std::chrono::duration<double, std::milli>(end - start).count();
}

/// Median milliseconds of `runs` calls, after one that warms up.
template <class Work>
double medianMilliseconds(int runs, Work&& work) {
  work();
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) times.push_back(millisecondsOf(work));
  return *quantileOf(std::move(times), 0.5);
}

}  // namespace boomwatch
