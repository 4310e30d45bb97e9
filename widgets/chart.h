#pragma once

#include <QColor>
#include <QFont>
#include <QImage>
#include <QRectF>

#include "report/figure.h"

class QPainter;

namespace boomwatch {

struct Theme;

/// What a chart is drawn with. Lines are told apart by their dashes and marks, zones by how dark
/// they are and by their names: colour is never needed.
struct ChartColours {
  QColor paper, ink, faint;  ///< behind it, lines and words, the grid
  QColor zone;               ///< of the zones; its alpha is that of the worst
  QBrush gap;                ///< where nothing is known

  static ChartColours print();  ///< black on white, for files
  static ChartColours fromTheme(const Theme& theme, const QColor& paper);
};

/// How many series are told apart; of more than these some look the same.
inline constexpr int chartStyles = 6;

/// Draws a figure into `area`: title (unless it is empty), legend, axes with titles, zones, gaps
/// with their names, lines and marks. Anything outside the axes is cut off there. GUI thread, or
/// any where fonts may be used.
void drawChart(QPainter& painter, const QRectF& area, const Figure& figure,
               const ChartColours& colours);

/// The plot's own rectangle inside `area`: where samples are drawn. Depends on fonts and figure.
QRectF chartPlot(const QFont& font, const QRectF& area, const Figure& figure);

/// Of x and y what the axes show; see ChartScale.
struct ChartRange {
  double low = 0.0, high = 1.0;
};
ChartRange chartRangeX(const Figure& figure);
ChartRange chartRangeY(const Figure& figure);

/// A picture for a file, in print().
QImage chartImage(const Figure& figure, const QSize& size = {960, 600});

}  // namespace boomwatch
