#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace boomwatch {

/// A surface over a plane across the line of sight, as a depth map or a height map gives it. Camera
/// frame, metres.
struct SurfaceMap {
  cv::Mat z;                     ///< CV_32FC1, z at the middle of each cell; NaN: not known
  double left = 0.0, top = 0.0;  ///< x and y of the upper left corner
  double cell = 1.0;             ///< side of a cell
  double spacing = 0.04;         ///< how far apart the points are wanted to be
};

/// Reads a map: an ESRI ASCII grid (.asc) of heights, or a YAML file that describes one.
///
///     file: terrain.asc         # or a picture of one channel, 8 or 16 bits, beside the YAML file
///     kind: height              # heights above a level, or depth: distances from the camera
///     metres_per_unit: 0.001    # default: 0.001 for pictures, 1 for grids
///     metres_per_pixel: 0.05    # pictures only, and needed there
///     camera_height: 12         # of the camera above height 0; default: 10 m above the highest
///     left: -5                  # x of the left edge; default: the camera looks at the middle
///     top: -5                   # y of the upper edge
///     spacing: 0.04             # of the points that are made of it
///
/// The camera looks down upon heights, north up: z = camera_height - height. In pictures of depth 0
/// means "not known", as NODATA_value does in grids. Throws Error naming file, line or key.
SurfaceMap readSurfaceMap(const std::filesystem::path& file);

}  // namespace boomwatch
