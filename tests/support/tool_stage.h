#pragma once

#include <memory>

#include "support/fake_tracker.h"
#include "support/flat_scene.h"
#include "tracking/tool_tracking.h"

namespace boomwatch::test {

/// A ToolTracking with fake trackers, fed with frames of a still wall.
struct ToolStage {
  std::shared_ptr<TrackerScript> script = std::make_shared<TrackerScript>();
  ToolTracking tracking{fakeTrackers(script)};
  TrackingParameters parameters;
  cv::Mat image = texture({160, 160});
  std::shared_ptr<Cloud> cloud = wallCloud(3.0F);
  double stamp = 0.0;

  ToolTrack frame() {
    stamp += 0.1;
    tracking.look(image, parameters);
    return tracking.locate(*cloud, stamp, parameters);
  }
  ToolTrack frames(int count) {
    ToolTrack last;
    for (int i = 0; i < count; ++i) last = frame();
    return last;
  }
};

}  // namespace boomwatch::test
