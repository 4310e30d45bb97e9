#pragma once

#include "frame/pinhole_camera.h"

namespace boomwatch {

/// The camera of all demo scenes: 768 x 576 pixels, 65 degrees wide.
inline constexpr PinholeCamera demoCamera = PinholeCamera::centred(768, 576, 600.0);

}  // namespace boomwatch
