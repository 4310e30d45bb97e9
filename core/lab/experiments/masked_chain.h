#pragma once

#include "frame/frame.h"
#include "pipeline/load_warning.h"
#include "pipeline/watched_environment.h"

namespace boomwatch {

struct YardTruth;  // simulation/yard/yard_truth.h

/// The pipeline's owners behind a perfect mask: demo:yard names the pixels of crane, tool and load.
/// So its errors come neither from the masks nor from the load's detection. Used by one thread.
class MaskedChain {
 public:
  struct Outcome {
    Clearance clearance;
    WarningLevel level = WarningLevel::NoDistance;
  };

  /// A frame of demo:yard with its load and a cloud that is organised as its picture; `truth` is
  /// the frame's.
  Outcome process(const Frame& frame, const YardTruth& truth, const Parameters& parameters);

 private:
  WatchedEnvironment m_environment;
  LoadWarning m_warning;
};

}  // namespace boomwatch
