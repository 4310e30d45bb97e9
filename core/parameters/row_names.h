#pragma once

#include <array>

#include "parameters/table_row.h"

/// Short names, choices and ranges for the rows of the parameter table. Compile time only.
namespace boomwatch::table_row {

/// Marks a text for translation.
#define TR(text) QT_TRANSLATE_NOOP("Parameters", text)

using P = Parameters;
using B = Bounds;
using F = FilterParameters;
using M = ModelParameters;
using C = ClearanceParameters;
using A = WatchParameters;
using W = WarningParameters;
using S = StereoParameters;
using L = LoadParameters;
using TP = TrackingParameters;
using V = ValidityParameters;

inline constexpr std::array<std::string_view, 2> matcherNames{"sgbm", "bm"};
inline constexpr std::array<std::string_view, 2> lowPassNames{"statistical", "radius"};
inline constexpr std::array<std::string_view, 2> methodNames{"exact", "rays"};
inline constexpr std::array<std::string_view, 3> updateNames{"thesis", "hysteresis", "log_odds"};
inline constexpr std::array<std::string_view, 2> projectionNames{"parallel", "perspective"};
inline constexpr std::array<std::string_view, 2> cellDepthNames{"nearest", "surface"};
inline constexpr std::array<std::string_view, 3> unknownNames{"ignore", "show", "solid"};
inline constexpr std::array<std::string_view, 5> trackerNames{"manual", "tld", "cmt", "klt",
                                                              "csrt"};
inline constexpr std::array<std::string_view, 2> toolPointNames{"right", "near"};
inline constexpr std::array<std::string_view, 4> loadNames{"auto", "scene", "manual", "detected"};
inline constexpr std::array<std::string_view, 3> shapeNames{"cylinder", "box", "auto"};
inline constexpr std::array<std::string_view, 2> dimensionNames{"learnt", "locked"};

inline constexpr Range coordinate{-1000, 1000, 0.1};
inline constexpr Range angle{-180, 180, 1};
inline constexpr Range loadSize{0.01, 100, 0.05};

}  // namespace boomwatch::table_row
