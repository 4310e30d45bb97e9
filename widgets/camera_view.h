#pragma once

#include <QPoint>
#include <QWidget>
#include <optional>

#include "box_draft.h"
#include "display.h"

namespace boomwatch {

/// The left image with the load box, the nearest point and the tool drawn over it.
///
/// A box that is dragged, or begun with B, sized with arrows (shift: by one pixel) and ended with
/// Enter, is where a tracker begins; Escape gives it up. A click, or arrows and Enter, picks the
/// tool; right click, Escape or Delete clears it. GUI thread.
class CameraView : public QWidget {
  Q_OBJECT

 public:
  explicit CameraView(QWidget* parent = nullptr);

  void setDisplay(const DisplayPtr& display);

  /// Where the picture is drawn, in widget coordinates; empty without a picture.
  QRectF pictureRect() const;
  /// The image pixel under a widget position; absent outside the picture.
  std::optional<QPoint> pixelAt(const QPointF& position) const;
  /// The box that is being drawn, in image pixels.
  std::optional<QRect> draft() const;

  /// Takes the keyboard, and begins a box where its cursor is.
  void beginBox();

  QSize sizeHint() const override { return {360, 260}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 signals:
  /// Pixel of the left image.
  void toolPicked(QPoint pixel);
  void toolCleared();
  /// Pixels of the left image; inside it, and large enough for a tracker.
  void boxDrawn(QRect box);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  QSize pictureSize() const;
  QPointF toWidget(const QPointF& pixel) const;
  QPoint pixelUnder(const QPointF& position) const;
  void drawWatched(QPainter& painter) const;
  void drawBox(QPainter& painter, const OrientedBox& box) const;
  void drawNearest(QPainter& painter) const;
  void drawCursor(QPainter& painter) const;
  void moveCursor(const QPoint& by);
  void confirm();
  void giveUp();

  DisplayPtr m_display;
  std::optional<QPoint> m_cursor;    ///< the keyboard's, in image pixels
  std::optional<QPointF> m_pressed;  ///< where the left button went down, in widget coordinates
  std::optional<BoxDraft> m_draft;
};

}  // namespace boomwatch
