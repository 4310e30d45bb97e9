#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace boomwatch::bench {

/// Median milliseconds of `runs` calls after one that warms up.
template <class Work>
double medianMilliseconds(int runs, Work&& work) {
  work();
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
  }
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2];
}

/// One figure a line: "name value unit bar"; `packaging/dev bench` gathers them into JSON.
/// `bar` says what is wanted, e.g. ">=15" or "<=3", or "-" for a figure without one.
inline void print(const char* name, double value, const char* unit, const char* bar) {
  std::printf("%s %.4g %s %s\n", name, value, unit, bar);
  std::fflush(stdout);
}

}  // namespace boomwatch::bench
