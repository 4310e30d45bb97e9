#include "pipeline/frame_checks.h"

#include <algorithm>
#include <cstring>

namespace boomwatch {
namespace {

/// One frame that shakes is no reason to forget the model; this many in a row are.
constexpr int movingFramesToForget = 3;

/// A live source may lose a few frames; after more, whatever came meanwhile is not in the model.
constexpr std::uint64_t maxLostFrames = 10;

bool samePixels(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  const std::size_t rowBytes = a.elemSize() * static_cast<std::size_t>(a.cols);
  for (int row = 0; row < a.rows; ++row) {
    if (std::memcmp(a.ptr(row), b.ptr(row), rowBytes) != 0) return false;
  }
  return true;
}

bool samePoints(const std::shared_ptr<const Cloud>& a, const std::shared_ptr<const Cloud>& b) {
  if (!a || !b) return a == b;
  return a->size() == b->size() &&
         (a->points.empty() ||
          std::memcmp(a->points.data(), b->points.data(), a->size() * sizeof(a->points[0])) == 0);
}

double fillOf(const Cloud& cloud) {
  if (cloud.points.empty()) return 0.0;
  const auto measured = std::count_if(cloud.points.begin(), cloud.points.end(), isMeasured);
  return static_cast<double>(measured) / static_cast<double>(cloud.size());
}

}  // namespace

/// Bit for bit: no real sensor gives the same picture twice.
bool FrameChecks::repeats(const FramePtr& frame) const {
  return m_previous && !frame->still && samePixels(frame->left, m_previous->left) &&
         samePixels(frame->right, m_previous->right) && samePoints(frame->cloud, m_previous->cloud);
}

bool FrameChecks::isFromAnotherTime(const Frame& frame) const {
  return m_previous && (frame.sequence < m_previous->sequence ||
                        frame.sequence > m_previous->sequence + maxLostFrames + 1);
}

FrameChecks::Verdict FrameChecks::examine(const FramePtr& frame, const cv::Mat& image,
                                          const Cloud& cloud,
                                          const ValidityParameters& parameters) {
  Verdict verdict;
  verdict.fill = fillOf(cloud);
  const bool jumped = isFromAnotherTime(*frame);
  m_equalFrames = repeats(frame) ? m_equalFrames + 1 : 1;
  m_previous = frame;
  // At 1 the check is off: no share is larger.
  const auto moved = m_equalFrames == 1 && parameters.sceneMotion < 1.0 ? m_motion.shareMoved(image)
                                                                        : std::nullopt;
  const bool moves = moved && *moved > parameters.sceneMotion;
  m_movingFrames = moves ? m_movingFrames + 1 : 0;
  verdict.modelIsStale = jumped || m_movingFrames >= movingFramesToForget;

  if (m_equalFrames >= parameters.identicalFrames) {
    verdict.reason = Reason::IdenticalFrames;
  } else if (verdict.fill < parameters.minFill) {
    verdict.reason = Reason::FewDepthPixels;
  } else if (moves) {
    verdict.reason = Reason::SceneMoves;
  }
  return verdict;
}

void FrameChecks::reset() { *this = FrameChecks(); }

Reason chainFault(const FrameChecks::Verdict& verdict, const ToolTrack& tool) {
  if (verdict.reason != Reason::None) return verdict.reason;
  return tool.lost() ? Reason::ToolLost : Reason::None;
}

}  // namespace boomwatch
