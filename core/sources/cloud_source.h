#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "sources/frame_source.h"

namespace boomwatch {

/// `cloud:PATH`: one PCD or PLY file, or a folder of them in natural order of their names. Metres,
/// camera frame, as readCloudFile says. The camera of organised clouds is fitted to the first of
/// them; see fitPinhole. Stamps come from the names where they are times, otherwise
/// they are a tenth of a second apart.
///
/// Throws Error when there is no cloud at `path`, or the only one there cannot be read. A file that
/// cannot be read amid others is a Bad frame whose message names it.
std::unique_ptr<FrameSource> openCloudSource(const std::filesystem::path& path,
                                             const std::string& address);

}  // namespace boomwatch
