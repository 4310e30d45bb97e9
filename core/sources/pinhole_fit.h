#pragma once

#include <optional>

#include "frame/cloud.h"

namespace boomwatch {

/// For clouds that come without intrinsics: the camera that maps the measured points of an
/// organised cloud onto their pixels, by least squares over a sample. Absent where there are too
/// few points, or where they do not fit to two pixels (rms). Pure.
std::optional<PinholeCamera> fitPinhole(const Cloud& cloud);

}  // namespace boomwatch
