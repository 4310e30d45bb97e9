#pragma once

#include "parameters/parameters.h"

namespace boomwatch::test {

/// What suits the recording of a conveyor belt.
inline Parameters beltParameters() {
  Parameters parameters;
  parameters.bounds = {-1.0, 1.1, -0.5, 0.4, 0.5, 2.5};
  parameters.model.resolution = 0.02;
  parameters.filter.clusterTolerance = 0.05;
  parameters.filter.clusterMinimum = 50;
  parameters.stereo.disparities = 160;
  parameters.stereo.blockSize = 9;
  parameters.stereo.speckleWindow = 200;
  parameters.stereo.texture = 0.1;  // plain cardboard
  return parameters;
}

}  // namespace boomwatch::test
