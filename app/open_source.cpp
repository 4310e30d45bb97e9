#include "open_source.h"

#include "base/error.h"
#include "simulation/demo_source.h"
#include "sources/bag/bag_source.h"
#include "sources/camera_source.h"
#include "sources/cloud_source.h"
#include "sources/depth_source.h"
#include "sources/map_source.h"
#include "sources/stereo_source.h"
#include "sources/still_source.h"

namespace boomwatch {

std::unique_ptr<FrameSource> openSource(const std::string& address, const SourceOptions& options) {
  const auto colon = address.find(':');
  const std::string kind = address.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : address.substr(colon + 1);
  if (colon != std::string::npos) {
    if (kind == "stereo") return repeatIfStill(openStereoSource(rest, address, options));
    if (kind == "cloud") return repeatIfStill(openCloudSource(rest, address));
    if (kind == "depth") return repeatIfStill(openDepthSource(rest, address));
    if (kind == "bag") return repeatIfStill(openBagSource(rest, address, options));
    if (kind == "map") return repeatIfStill(openMapSource(rest, address));
    if (kind == "camera") return openCameraSource(rest, address, options);
    if (kind == "demo") return openDemoSource(rest, address);
  }
  throw Error("source '" + address + "'", "it does not begin with a kind of source",
              "Give stereo:PATH, cloud:PATH, depth:PATH, bag:PATH, map:FILE, camera:LEFT,RIGHT or "
              "demo:NAME.");
}

}  // namespace boomwatch
