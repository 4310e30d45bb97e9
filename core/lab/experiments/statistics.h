#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace boomwatch {

/// The value that a share 0..1 of all values do not exceed (the nearest rank); absent without any.
inline std::optional<double> quantileOf(std::vector<double> values, double share) {
  if (values.empty()) return std::nullopt;
  const auto rank =
      static_cast<std::size_t>(std::clamp(std::ceil(share * static_cast<double>(values.size())),
                                          1.0, static_cast<double>(values.size())));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

inline std::optional<double> meanOf(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Share 0..1 of the values above `limit`; absent without any.
inline std::optional<double> shareAbove(const std::vector<double>& values, double limit) {
  if (values.empty()) return std::nullopt;
  const auto above =
      std::count_if(values.begin(), values.end(), [&](double value) { return value > limit; });
  return static_cast<double>(above) / static_cast<double>(values.size());
}

}  // namespace boomwatch
