#include "marks.h"

namespace boomwatch {
namespace {

constexpr QColor edge(0x0b, 0x0d, 0x0f, 200);

QPen pen(const QColor& colour, double width) {
  return {colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

}  // namespace

void drawMarkedLines(QPainter& painter, const QList<QLineF>& lines, const QColor& colour,
                     double width) {
  painter.setPen(pen(edge, width + 2.0));
  painter.drawLines(lines);
  painter.setPen(pen(colour, width));
  painter.drawLines(lines);
}

void drawMarkedPolygon(QPainter& painter, const QPolygonF& polygon, const QColor& colour) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen(edge, 4.0));
  painter.drawPolygon(polygon);
  painter.setPen(pen(colour, 2.0));
  painter.drawPolygon(polygon);
}

void drawNearestPair(QPainter& painter, const QPointF& onLoad, const QPointF& onEnvironment,
                     const Theme& theme) {
  drawMarkedLines(painter, {QLineF(onLoad, onEnvironment)}, theme.nearest, 1.5);
  const QRectF square(onLoad - QPointF(3, 3), QSizeF(6, 6));
  painter.setPen(pen(edge, 1.5));
  painter.setBrush(theme.load);
  painter.drawRect(square);
  painter.setBrush(Qt::NoBrush);
  for (const bool under : {true, false}) {
    painter.setPen(under ? pen(edge, 4.5) : pen(theme.nearest, 2.5));
    painter.drawEllipse(onEnvironment, 8.0, 8.0);
    painter.drawLine(onEnvironment - QPointF(12, 0), onEnvironment - QPointF(4, 0));
    painter.drawLine(onEnvironment + QPointF(4, 0), onEnvironment + QPointF(12, 0));
    painter.drawLine(onEnvironment - QPointF(0, 12), onEnvironment - QPointF(0, 4));
    painter.drawLine(onEnvironment + QPointF(0, 4), onEnvironment + QPointF(0, 12));
  }
}

void drawCrosshair(QPainter& painter, const QPointF& at, const QColor& colour,
                   const QColor& outline) {
  for (const bool under : {true, false}) {
    painter.setPen(under ? pen(outline, 4.0) : pen(colour, 2.0));
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      painter.drawLine(at + way * 4.0, at + way * 13.0);
    }
  }
}

void drawSentence(QPainter& painter, const QRectF& area, const QString& sentence,
                  const Theme& theme) {
  painter.setPen(theme.canvasText);
  painter.drawText(area.adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, sentence);
}

}  // namespace boomwatch
