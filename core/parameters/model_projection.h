#pragma once

namespace boomwatch {

/// Shape of the cells of a model in space.
enum class ModelProjection {
  Parallel,    ///< columns along z, all of the same width (the thesis's)
  Perspective  ///< image rays; a near object leaves no gap behind it (Fig. 17)
};

}  // namespace boomwatch
