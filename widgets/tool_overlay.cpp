#include "tool_overlay.h"

#include <QCoreApplication>

#include "marks.h"
#include "tool_texts.h"

namespace boomwatch {
namespace {

class ToolOverlay {
  Q_DECLARE_TR_FUNCTIONS(ToolOverlay)
};

/// Nearer than this to the camera's plane, nothing can be projected.
constexpr float nearPlane = 0.05F;

QRectF mapped(const QRectF& box, const ToWidget& toWidget) {
  // The box's edges are those of its pixels.
  const QPointF half(0.5, 0.5);
  return {toWidget(box.topLeft() - half), toWidget(box.bottomRight() - half)};
}

/// On a ground of its own, above `box` or, where that is outside the picture, inside it; in several
/// lines where the picture is too narrow for one.
void drawLabel(QPainter& painter, const QRectF& box, const QString& text, const Theme& theme) {
  constexpr int flags = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;
  const QRectF picture = painter.clipBoundingRect();
  const QSizeF room(picture.width() - 12.0, picture.height());
  const QRectF words = QFontMetricsF(painter.font()).boundingRect({{}, room}, flags, text);
  QRectF area(box.left(), box.top(), words.width() + 8.0, words.height() + 2.0);
  area.moveBottom(box.top() - 2.0);
  if (area.top() < picture.top()) area.moveTop(box.top() + 2.0);
  if (area.right() > picture.right()) area.moveRight(picture.right());
  if (area.left() < picture.left()) area.moveLeft(picture.left());
  QColor ground = theme.canvas;
  ground.setAlpha(200);
  painter.fillRect(area, ground);
  painter.setPen(theme.canvasText);
  painter.drawText(area.adjusted(4.0, 0.0, 0.0, 0.0), flags, text);
}

enum class Line { Solid, Broken };

QPen penOf(const QColor& colour, Line line) {
  QPen pen(colour, 2.0);
  pen.setCapStyle(Qt::FlatCap);
  if (line == Line::Broken) pen.setDashPattern({3.0, 3.0});
  return pen;
}

void drawFrame(QPainter& painter, const QRectF& box, const QColor& colour, Line line,
               const Theme& theme) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.outline, 4.0));
  painter.drawRect(box);
  painter.setPen(penOf(colour, line));
  painter.drawRect(box);
}

void drawUnseen(QPainter& painter, const Display& display, const ToWidget& toWidget,
                const Theme& theme) {
  const ToolTrack& tool = display.result->tool;
  const QRectF corner(painter.clipBoundingRect().topLeft() + QPointF(6, 6), QSizeF(0, 0));
  drawLabel(painter, corner, toolSentence(tool, display.result->parameters.tracking), theme);
  if (!tool.point || !display.projection || tool.point->z() < nearPlane) return;
  const QPointF at = toWidget(pixelOf(*display.projection, tool.point->cast<double>()));
  painter.setBrush(Qt::NoBrush);
  for (const bool under : {true, false}) {
    painter.setPen(under ? QPen(theme.outline, 4.0) : penOf(theme.tool, Line::Broken));
    painter.drawEllipse(at, 14.0, 14.0);
  }
}

}  // namespace

void drawTool(QPainter& painter, const Display& display, const ToWidget& toWidget,
              const Theme& theme) {
  const ToolTrack& tool = display.result->tool;
  if (tool.running() && !tool.box) drawUnseen(painter, display, toWidget, theme);
  if (tool.box) {
    const QRectF box =
        mapped({tool.box->x, tool.box->y, tool.box->width, tool.box->height}, toWidget);
    drawFrame(painter, box, theme.tool, tool.age == 0.0 ? Line::Solid : Line::Broken, theme);
    drawLabel(painter, box, toolLabel(tool), theme);
  }
  if (tool.pixel) {
    drawCrosshair(painter, toWidget(QPointF(tool.pixel->x, tool.pixel->y)), theme.tool,
                  theme.outline);
  }
}

void drawDraft(QPainter& painter, const QRect& box, bool largeEnough, const ToWidget& toWidget,
               const Theme& theme) {
  const QRectF drawn = mapped(QRectF(box), toWidget);
  drawFrame(painter, drawn, Qt::white, Line::Broken, theme);
  const QString size = ToolOverlay::tr("%1 x %2").arg(box.width()).arg(box.height());
  drawLabel(painter, drawn, largeEnough ? size : ToolOverlay::tr("%1: too small").arg(size), theme);
}

}  // namespace boomwatch
