#pragma once

#include <filesystem>
#include <memory>

#include "sources/frame_source.h"

namespace boomwatch {

/// A depth map or height map (see readSurfaceMap) as the environment: one still cloud without a
/// camera, a point every `spacing` metres, between the map's cells by bilinear interpolation where
/// all four neighbours are known. Throws Error when it cannot be read, or would take more than 4
/// million points.
std::unique_ptr<FrameSource> openMapSource(const std::filesystem::path& file,
                                           const std::string& address);

}  // namespace boomwatch
