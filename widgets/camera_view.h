#pragma once

#include <QPoint>
#include <QWidget>
#include <optional>

#include "display.h"

namespace boomwatch {

/// The left image with the load box, the nearest point and the tool drawn over it.
///
/// A click, or arrows (shift: by one pixel) and Enter, picks the tool; right click, Escape or
/// Delete clears it. GUI thread.
class CameraView : public QWidget {
  Q_OBJECT

 public:
  explicit CameraView(QWidget* parent = nullptr);

  void setDisplay(const DisplayPtr& display);

  /// Where the picture is drawn, in widget coordinates; empty without a picture.
  QRectF pictureRect() const;
  /// The image pixel under a widget position; absent outside the picture.
  std::optional<QPoint> pixelAt(const QPointF& position) const;

  QSize sizeHint() const override { return {360, 260}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 signals:
  /// Pixel of the left image.
  void toolPicked(QPoint pixel);
  void toolCleared();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  QSize pictureSize() const;
  QPointF toWidget(const QPointF& pixel) const;
  void drawLoad(QPainter& painter) const;
  void drawNearest(QPainter& painter) const;
  void drawCursor(QPainter& painter) const;
  void moveCursor(const QPoint& by);

  DisplayPtr m_display;
  std::optional<QPoint> m_cursor;  ///< the keyboard's, in image pixels
};

}  // namespace boomwatch
