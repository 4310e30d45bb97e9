#pragma once

#include <memory>
#include <optional>

#include "frame/cloud.h"

namespace boomwatch {

/// How much the depth of an organised cloud wavers from pixel to pixel: the standard deviation of
/// inverse depth, 1/m, which is the same near and far for a stereo or a structured-light camera
/// (dz = z^2 times it; Khoshelham and Elberink 2012 measured 0.0014 for a Kinect). From the second
/// differences along the rows, which vanish on planes; the median of them, so that edges do not
/// count. Absent where the cloud is not organised or too little was measured. Pure.
std::optional<double> depthNoise(const Cloud& cloud);

/// The cloud with that noise taken out: every point moves along its ray to the mean inverse depth
/// of the `window` x `window` pixels around it (odd, at least 3) that may be of one surface with
/// it, so that edges stay. A clearance is a minimum over many cells, and sees of the noise only
/// what points towards it. The same cloud where there is no noise, or the window is below 3. Pure.
std::shared_ptr<const Cloud> withoutDepthNoise(const std::shared_ptr<const Cloud>& cloud,
                                               int window);

}  // namespace boomwatch
