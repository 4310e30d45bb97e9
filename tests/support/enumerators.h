#pragma once

#include <vector>

#include "frame/clearance.h"
#include "parameters/parameters.h"
#include "pipeline/warning_level.h"

/// All enumerators of an enumeration, for tests that go through them. Each switch names every one
/// and has no default: the compiler finds one that is missing.
namespace boomwatch {

constexpr bool isEnumerator(Reason value) {
  switch (value) {
    case Reason::None:
    case Reason::NoFrame:
    case Reason::UnreadableFrame:
    case Reason::IdenticalFrames:
    case Reason::FewDepthPixels:
    case Reason::SceneMoves:
    case Reason::ToolLost:
    case Reason::NoTool:
    case Reason::NoLoad:
    case Reason::LoadNotSeen:
    case Reason::LoadOutside:
    case Reason::ToolNotSeen:
    case Reason::NoModel:
    case Reason::SearchTooShort:
    case Reason::NothingObserved:
      return true;
  }
  return false;
}

constexpr bool isEnumerator(WarningLevel value) {
  switch (value) {
    case WarningLevel::Clear:
    case WarningLevel::Caution:
    case WarningLevel::Warning:
    case WarningLevel::Collision:
    case WarningLevel::NoDistance:
      return true;
  }
  return false;
}

constexpr bool isEnumerator(LoadShape value) {
  switch (value) {
    case LoadShape::Cylinder:
    case LoadShape::Box:
    case LoadShape::Auto:
      return true;
  }
  return false;
}

constexpr bool isEnumerator(StereoMatcherKind value) {
  switch (value) {
    case StereoMatcherKind::Sgbm:
    case StereoMatcherKind::Bm:
      return true;
  }
  return false;
}

constexpr bool isEnumerator(ModelProjection value) {
  switch (value) {
    case ModelProjection::Parallel:
    case ModelProjection::Perspective:
      return true;
  }
  return false;
}

/// In order, from 0 to the first number that is none.
template <class Enumeration>
std::vector<Enumeration> every() {
  std::vector<Enumeration> all;
  for (int k = 0; isEnumerator(static_cast<Enumeration>(k)); ++k) {
    all.push_back(static_cast<Enumeration>(k));
  }
  return all;
}

/// Why there is no distance: every reason but None.
inline std::vector<Reason> everyFault() {
  std::vector<Reason> all = every<Reason>();
  std::erase(all, Reason::None);
  return all;
}

}  // namespace boomwatch
