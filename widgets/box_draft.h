#pragma once

#include <QPoint>
#include <QRect>
#include <QSize>

namespace boomwatch {

/// A box while it is drawn: from a corner that stays to one that is moved. Image pixels; it never
/// leaves the picture.
class BoxDraft {
 public:
  /// `picture` must not be empty.
  BoxDraft(const QPoint& corner, const QSize& picture);

  void moveTo(const QPoint& corner);
  void moveBy(const QPoint& step) { moveTo(m_moved + step); }

  /// Both corners' pixels belong to it.
  QRect box() const;
  /// Whether a tracker can begin with it.
  bool isLargeEnough() const;

 private:
  QRect m_picture;
  QPoint m_fixed;
  QPoint m_moved;
};

}  // namespace boomwatch
