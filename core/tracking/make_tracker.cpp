#include "tracking/make_tracker.h"
#include "tracking/cmt_tracker.h"
#include "tracking/csrt_tracker.h"
#include "tracking/klt_tracker.h"
#include "tracking/tld_tracker.h"
#include "tracking/tracker.h"

namespace boomwatch {

std::unique_ptr<Tracker> makeTracker(TrackerKind kind) {
  switch (kind) {
    case TrackerKind::Manual:
      return nullptr;
    case TrackerKind::Klt:
      return std::make_unique<KltTracker>();
    case TrackerKind::Csrt:
      return std::make_unique<CsrtTracker>();
    case TrackerKind::Tld:
      return std::make_unique<TldTracker>();
    case TrackerKind::Cmt:
      return std::make_unique<CmtTracker>();
  }
  return nullptr;
}

}  // namespace boomwatch
