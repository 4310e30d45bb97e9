#include "lab/evaluation/contestant.h"

#include <algorithm>
#include <opencv2/tracking.hpp>
#include <opencv2/tracking/tracking_legacy.hpp>

#include "base/error.h"
#include "lab/evaluation/opencv_tracker.h"
#include "tracking/make_tracker.h"

namespace boomwatch {
namespace {

Contestant ours(const char* name, TrackerKind kind) {
  return {name, true, [kind] { return makeTracker(kind); }};
}

template <class Engine>
Contestant opencvs(const char* name) {
  return {name, false,
          [] { return std::make_unique<OpencvTracker>([] { return Engine::create(); }); }};
}

}  // namespace

std::vector<Contestant> contestants() {
  return {ours("tld", TrackerKind::Tld),
          ours("cmt", TrackerKind::Cmt),
          ours("klt", TrackerKind::Klt),
          ours("csrt", TrackerKind::Csrt),
          opencvs<cv::legacy::TrackerTLD>("opencv_tld"),
          opencvs<cv::legacy::TrackerCSRT>("opencv_csrt"),
          opencvs<cv::legacy::TrackerMedianFlow>("opencv_medianflow")};
}

std::vector<Contestant> contestantsNamed(std::span<const std::string> names) {
  const std::vector<Contestant> all = contestants();
  if (names.empty()) return all;
  std::vector<Contestant> chosen;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, &Contestant::name);
    if (found == all.end()) {
      std::string choices;
      for (const Contestant& one : all) {
        choices.append(choices.empty() ? "" : ", ").append(one.name);
      }
      throw Error("tracker", "'" + name + "' is none that can be evaluated",
                  "Choose from " + choices + ".");
    }
    chosen.push_back(*found);
  }
  return chosen;
}

}  // namespace boomwatch
