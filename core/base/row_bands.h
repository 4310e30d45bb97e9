#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <opencv2/core/types.hpp>
#include <thread>
#include <vector>

namespace boomwatch {

/// Runs work(cv::Range) for bands of 32 of 0..rows, on as many threads as there are cores, and
/// returns when all are done; throws what they throw. Not OpenCV's parallel_for_: what its pool
/// (Debian's TBB) synchronises ThreadSanitizer cannot see, and takes every use of it for a race.
template <class Work>
void inBands(int rows, const Work& work) {
  constexpr int bandRows = 32;
  const int bands = (rows + bandRows - 1) / bandRows;
  std::atomic<int> next{0};
  const auto runSome = [&] {
    for (int band = next++; band < bands; band = next++) {
      work(cv::Range(band * bandRows, std::min(rows, (band + 1) * bandRows)));
    }
  };
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<std::future<void>> others;
  for (int k = 1; k < std::min(cores, bands); ++k) {
    others.push_back(std::async(std::launch::async, runSome));
  }
  runSome();
  for (auto& other : others) other.get();
}

}  // namespace boomwatch
