#pragma once

#include <QPainter>
#include <QPolygonF>

#include "theme.h"

namespace boomwatch {

/// Marks drawn over pictures and maps: each has a shape of its own besides its colour, and a dark
/// edge that keeps it visible on any ground. Widget coordinates.

/// Lines with a dark edge; no edge covers another line.
void drawMarkedLines(QPainter& painter, const QList<QLineF>& lines, const QColor& colour,
                     double width);
void drawMarkedPolygon(QPainter& painter, const QPolygonF& polygon, const QColor& colour);

/// Both ends of the shortest line: a square on the load, a ring with a cross on the environment.
void drawNearestPair(QPainter& painter, const QPointF& onLoad, const QPointF& onEnvironment,
                     const Theme& theme);

/// Four strokes around an open centre, so that the pixel itself stays in sight.
void drawCrosshair(QPainter& painter, const QPointF& at, const QColor& colour,
                   const QColor& outline);

/// A sentence where there is nothing to draw.
void drawSentence(QPainter& painter, const QRectF& area, const QString& sentence,
                  const Theme& theme);

}  // namespace boomwatch
