#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "display.h"
#include "distance_history.h"
#include "report/figure.h"

namespace boomwatch {

/// The last minute of the distance, against the source's clock, with the zones of caution and
/// warning, the truth where the source knows it (dashed), and hatching with the reason where there
/// is no distance. Told apart without colours. GUI thread.
class DistancePlot : public QWidget {
  Q_OBJECT

 public:
  explicit DistancePlot(QWidget* parent = nullptr);

  void setDisplay(const DisplayPtr& display);
  /// Another source follows, or another place in it.
  void clear();

  const DistanceHistory& history() const { return m_history; }
  /// What is drawn: seconds before now, and metres.
  Figure figure() const;
  /// About the moment at a place of the widget; empty where there is none.
  QString textAt(const QPoint& place) const;

  QSize sizeHint() const override { return {600, 180}; }
  QSize minimumSizeHint() const override { return {200, 110}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF area() const;

  DistanceHistory m_history;
  WarningParameters m_warning;
  QElapsedTimer m_sinceFrame;
};

}  // namespace boomwatch
