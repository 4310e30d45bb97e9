#pragma once

#include <QPointF>
#include <QString>
#include <QWidget>
#include <optional>

#include "display.h"

namespace boomwatch {

enum class MapKind { Probability, Environment };

/// One of the two maps of the model, a pixel a cell: x right, y down, as in the picture. Unobserved
/// cells are hatched. The environment map also shows load, search rays and nearest point.
///
/// The wheel zooms about the cursor, a drag pans, a double click or F fits the map. Arrow keys pan,
/// + and - zoom. GUI thread.
class MapView : public QWidget {
  Q_OBJECT

 public:
  explicit MapView(MapKind kind, QWidget* parent = nullptr);

  void setDisplay(const DisplayPtr& display);

  /// Cell (column, row) under a widget position; absent outside the map.
  std::optional<QPoint> cellAt(const QPointF& position) const;
  /// Widget position of a point of the model plane, metres.
  QPointF positionOf(double x, double y) const;
  /// Pixels a cell.
  double scale() const { return m_scale; }
  /// "x 1.20 m  y -0.30 m  z 3.70 m  P 0.62  occupied"; empty outside the map. In perspective a
  /// cell without a surface has the direction "x/z 0.20  y/z -0.10" instead of a position.
  QString readout(const QPoint& cell) const;

  QSize sizeHint() const override { return {360, 260}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 public slots:
  void fit();
  /// Zooms by `factor` about `anchor` (widget coordinates).
  void zoom(double factor, const QPointF& anchor);

 signals:
  /// The read-out under the cursor; empty when the cursor leaves the map.
  void readoutChanged(const QString& text);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  const QImage& image() const;
  /// Null when there is no map to show.
  const EnvironmentModel* model() const;
  QRectF mapArea() const;
  double fittingScale() const;
  void drawCells(QPainter& painter);
  void drawOverlay(QPainter& painter) const;
  /// Outlines the cells of ignored components.
  void drawSuppressed(QPainter& painter) const;
  void drawStrip(QPainter& painter) const;
  void pan(const QPointF& by);
  void updateReadout();

  MapKind m_kind;
  DisplayPtr m_display;
  double m_scale = 1.0;
  QPointF m_origin;      ///< widget position of the map's upper left corner
  bool m_fitted = true;  ///< the map fits the widget until the person zooms or pans
  std::optional<QPointF> m_cursor;
  std::optional<QPointF> m_dragFrom;
  QString m_readout;
  QImage m_reduced;        ///< the map scaled down, while cells are smaller than pixels
  qint64 m_reducedOf = 0;  ///< cache key of its image
};

}  // namespace boomwatch
