#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "frame/cloud.h"

namespace boomwatch {

/// A cloud as a file holds it.
struct CloudFile {
  std::shared_ptr<Cloud> cloud;       ///< without camera: neither format names it
  cv::Mat image;                      ///< CV_8UC3 (BGR), the cloud's size; empty unless organised
                                      ///< and coloured
  std::vector<std::uint32_t> labels;  ///< one a point where the file has a `label` field, or empty
};

/// Reads a PCD (ascii, binary, binary_compressed) or a PLY (ascii, binary of either byte order).
///
/// Coordinates are taken as metres in the camera frame (x right, y down, z forward), as they are in
/// the file: neither format says its unit, and PCD's VIEWPOINT is not applied. They may be of any
/// type and are kept as floats. Points that are not finite, and points at exactly 0 0 0 (how many
/// sensors write "no return"), become unmeasured. PCDs are organised when HEIGHT is above 1, PLYs
/// when `obj_info num_cols` and `num_rows` say so.
///
/// Every size the header claims is checked against the file's real size, and against 50 million
/// points, before anything is allocated. Throws Error naming the file (and the line of its header).
/// Pure; any thread.
CloudFile readCloudFile(const std::filesystem::path& file);

/// By its extension: .pcd or .ply, in either case.
bool isCloudFile(const std::filesystem::path& file);

}  // namespace boomwatch
