#pragma once

#include <memory>
#include <string>

#include "sources/frame_source.h"

namespace boomwatch {

/// Opens `stereo:PATH`, `cloud:PATH`, `depth:PATH`, `map:FILE`, `camera:LEFT,RIGHT` or `demo:NAME`.
/// Throws Error when the address or what it names cannot be used.
std::unique_ptr<FrameSource> openSource(const std::string& address,
                                        const SourceOptions& options = {});

}  // namespace boomwatch
