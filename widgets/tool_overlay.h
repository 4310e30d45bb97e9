#pragma once

#include <QPainter>
#include <functional>

#include "display.h"
#include "theme.h"

namespace boomwatch {

/// From image pixels (a pixel's coordinates are those of its centre) to widget coordinates.
using ToWidget = std::function<QPointF(const QPointF&)>;

/// The tool over the picture: its box, solid where its point was measured in this frame and broken
/// where it was not, with its confidence in words; a crosshair at its pixel; and while it is not
/// seen, a broken ring where it is taken to be, and how long that has been so.
void drawTool(QPainter& painter, const Display& display, const ToWidget& toWidget,
              const Theme& theme);

/// A box of image pixels that is being drawn, with its size, or with "too small".
void drawDraft(QPainter& painter, const QRect& box, bool largeEnough, const ToWidget& toWidget,
               const Theme& theme);

}  // namespace boomwatch
