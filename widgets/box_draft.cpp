#include "box_draft.h"

#include <algorithm>

#include "tracking/tracker.h"

namespace boomwatch {
namespace {

QPoint inside(const QPoint& point, const QRect& picture) {
  return {std::clamp(point.x(), picture.left(), picture.right()),
          std::clamp(point.y(), picture.top(), picture.bottom())};
}

}  // namespace

BoxDraft::BoxDraft(const QPoint& corner, const QSize& picture)
    : m_picture({}, picture), m_fixed(inside(corner, m_picture)), m_moved(m_fixed) {}

void BoxDraft::moveTo(const QPoint& corner) { m_moved = inside(corner, m_picture); }

QRect BoxDraft::box() const {
  return {QPoint(std::min(m_fixed.x(), m_moved.x()), std::min(m_fixed.y(), m_moved.y())),
          QPoint(std::max(m_fixed.x(), m_moved.x()), std::max(m_fixed.y(), m_moved.y()))};
}

bool BoxDraft::isLargeEnough() const {
  return std::min(box().width(), box().height()) >= Tracker::minSide;
}

}  // namespace boomwatch
