#pragma once

#include "parameters/parameters.h"

namespace boomwatch {

/// Throws Error that names the key when a setting is outside the range of the parameter table, or
/// when OpenCV's matcher of the chosen kind refuses it: the only check of stereo settings there is.
void requireMatcherSettings(const StereoParameters& stereo);

}  // namespace boomwatch
