#pragma once

namespace boomwatch {

/// How the cells of a model lie in space.
enum class ModelProjection {
  Parallel,    ///< columns along z, all of the same width (the thesis's)
  Perspective  ///< image rays through the camera: a near thing leaves no gap behind it (Fig. 17)
};

}  // namespace boomwatch
