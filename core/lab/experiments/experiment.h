#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/parameters.h"
#include "report/chapter.h"

namespace boomwatch {

/// A figure of the benchmark programs (see packaging/dev bench).
struct BenchFigure {
  std::string name;
  double value = 0.0;
  std::string unit;
};

/// What experiments may need to know.
struct ExperimentSetup {
  Parameters parameters;
  std::vector<std::filesystem::path> recordings;  ///< tracking sequences with ground truth
  std::vector<BenchFigure> bench;                 ///< empty: no benchmark was run
  std::size_t sequences = 50;                     ///< random yards
  std::optional<std::size_t> frames;              ///< of each sequence; absent: yardFrames, all
  double hours = 1.0;                             ///< of simulated work, for its alarms
  std::uint64_t firstSeed = 1;                    ///< the yards have this seed and those after it

  static constexpr std::size_t yardFrames = 200;
  std::size_t framesOfAYard() const { return frames.value_or(yardFrames); }
  static constexpr std::size_t framesOfAShift = 1200;  ///< a minute, then another yard
  /// Of those hours, 20 a second; at least one.
  std::size_t framesOfWork() const {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(hours * 20.0 * 3600.0 - 1e-6)));
  }
  std::size_t shifts() const { return (framesOfWork() + framesOfAShift - 1) / framesOfAShift; }
  /// Of all yards: those of the work come after the others.
  std::uint64_t lastSeed() const { return firstSeed + sequences + shifts() - 1; }
  /// How much of what is usual in other experiments: with shorter yards so much less of it.
  std::size_t share(std::size_t usual) const {
    const std::size_t part = usual * std::min(framesOfAYard(), yardFrames) / yardFrames;
    return std::max<std::size_t>(1, part);
  }
};

/// Called now and then with how much of the experiment is done, 0..1; false ends it.
using ExperimentProgress = std::function<bool(double share)>;

/// One figure or table of the thesis, or what it could not do.
struct Experiment {
  std::string_view name;  ///< one or two words, for the progress
  /// Absent when the progress said no. Throws what sources throw.
  std::optional<Chapter> (*run)(const ExperimentSetup& setup, const ExperimentProgress& progress);
};

/// All of them, in the order of the report.
const std::vector<Experiment>& experiments();

}  // namespace boomwatch
