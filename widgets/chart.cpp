#include "chart.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "chart_scale.h"
#include "theme.h"

namespace boomwatch {
namespace {

constexpr double gap = 8.0;
constexpr double markSize = 4.0;

struct Line {
  QVector<qreal> dashes;  ///< empty: solid
  double width;
};

Line lineOf(int index) {
  static const std::array<Line, chartStyles> lines{Line{{}, 2.0},         Line{{6, 3}, 1.6},
                                                   Line{{1.5, 2.5}, 1.8}, Line{{8, 3, 1.5, 3}, 1.5},
                                                   Line{{}, 1.0},         Line{{3, 3}, 1.0}};
  return lines[static_cast<std::size_t>(index % chartStyles)];
}

QPen penOf(int index, const QColor& ink) {
  const Line line = lineOf(index);
  QPen pen(ink, line.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  if (!line.dashes.isEmpty()) pen.setDashPattern(line.dashes);
  return pen;
}

/// Disc, square, triangle, cross, ring, hollow square.
void drawMark(QPainter& painter, const QPointF& p, int index, const ChartColours& colours) {
  const double r = markSize;
  painter.setPen(QPen(colours.ink, 1.4));
  painter.setBrush(index % chartStyles < 3 ? QBrush(colours.ink) : QBrush(colours.paper));
  switch (index % chartStyles) {
    case 0:
    case 4:
      painter.drawEllipse(p, r, r);
      break;
    case 1:
    case 5:
      painter.drawRect(QRectF(p - QPointF(r, r) * 0.9, QSizeF(2, 2) * r * 0.9));
      break;
    case 2:
      painter.drawPolygon(QPolygonF{p + QPointF(0, -r), p + QPointF(r, r), p + QPointF(-r, r)});
      break;
    default:
      painter.drawLine(p - QPointF(r, r), p + QPointF(r, r));
      painter.drawLine(p + QPointF(-r, r), p + QPointF(r, -r));
  }
  painter.setBrush(Qt::NoBrush);
}

bool hasLine(const Series& series) { return series.kind != Series::Kind::Marks; }
bool hasMarks(const Series& series) {
  return series.kind == Series::Kind::Marked || series.kind == Series::Kind::Marks;
}

QString words(const std::string& text) { return QString::fromStdString(text); }

template <class Value>
ChartRange rangeOf(const Figure& figure, Value value) {
  ChartRange range{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
  for (const Series& series : figure.series) {
    for (const Sample& sample : series.samples) {
      const std::optional<double> at = value(sample);
      if (!at || !std::isfinite(*at)) continue;
      range.low = std::min(range.low, *at);
      range.high = std::max(range.high, *at);
    }
  }
  if (range.low > range.high) return {};
  return range;
}

ChartScale scaleOfX(const Figure& figure) {
  const ChartRange range = chartRangeX(figure);
  return {figure.x, range.low, range.high};
}
ChartScale scaleOfY(const Figure& figure) {
  const ChartRange range = chartRangeY(figure);
  return {figure.y, range.low, range.high};
}

/// A row of names with a piece of their line each; as many rows as it takes.
class LegendRows {
 public:
  LegendRows(const QFont& font, double width, const Figure& figure) : m_metrics(font) {
    if (figure.series.size() < 2) return;
    double x = 0.0;
    for (const Series& series : figure.series) {
      const double needed = sample + gap / 2 + m_metrics.horizontalAdvance(words(series.name));
      if (x > 0.0 && x + needed > width) x = 0.0, ++m_rows;
      m_places.emplace_back(x, m_rows);
      x += needed + 2 * gap;
    }
    ++m_rows;
  }

  double height() const { return m_rows * rowHeight(); }

  void draw(QPainter& painter, const QPointF& corner, const Figure& figure,
            const ChartColours& colours) const {
    for (std::size_t k = 0; k < m_places.size(); ++k) {
      const QPointF left = corner + QPointF(m_places[k].x(), (m_places[k].y() + 0.5) * rowHeight());
      const int style = static_cast<int>(k);
      painter.setPen(penOf(style, colours.ink));
      if (hasLine(figure.series[k])) painter.drawLine(left, left + QPointF(sample, 0));
      if (hasMarks(figure.series[k])) {
        drawMark(painter, left + QPointF(sample / 2, 0), style, colours);
      }
      painter.setPen(colours.ink);
      painter.drawText(left + QPointF(sample + gap / 2, m_metrics.ascent() / 2 - 1),
                       words(figure.series[k].name));
    }
  }

 private:
  static constexpr double sample = 36.0;
  double rowHeight() const { return m_metrics.height() + 2; }

  QFontMetricsF m_metrics;
  std::vector<QPointF> m_places;  ///< x, row
  int m_rows = 0;
};

struct Parts {
  QRectF title, legend, plot;

  Parts(const QFont& font, const QRectF& area, const Figure& figure) {
    const QFontMetricsF metrics(font);
    const double line = metrics.height();
    double widest = 0.0;
    for (const auto& tick : scaleOfY(figure).ticks()) {
      widest = std::max(widest, metrics.horizontalAdvance(tick.text));
    }
    const double left = area.left() + line + widest + 2 * gap;
    const double width = std::max(10.0, area.right() - gap - left);
    const double titleHeight = figure.title.empty() ? 0.0 : line + gap;
    title = {left, area.top() + gap / 2, width, titleHeight};
    legend = {left, title.bottom(), width, LegendRows(font, width, figure).height()};
    const double top = legend.bottom() + gap;
    plot = {left, top, width, std::max(10.0, area.bottom() - 2 * line - gap - top)};
  }
};

class ChartPainter {
 public:
  ChartPainter(QPainter& painter, const QRectF& area, const Figure& figure,
               const ChartColours& colours)
      : m_painter(painter),
        m_area(area),
        m_figure(figure),
        m_colours(colours),
        m_parts(painter.font(), area, figure),
        m_x(scaleOfX(figure)),
        m_y(scaleOfY(figure)) {}

  void draw() {
    drawZones();
    drawGrid();
    drawGaps();
    m_painter.save();
    m_painter.setClipRect(m_parts.plot.adjusted(-markSize, -markSize, markSize, markSize));
    for (std::size_t k = 0; k < m_figure.series.size(); ++k) drawSeries(static_cast<int>(k));
    m_painter.restore();
    drawZoneNames();
    drawFrame();
    drawWords();
  }

 private:
  QPointF place(double x, double y) const { return {xOf(x), yOf(y)}; }
  double xOf(double x) const {
    return m_parts.plot.left() + std::clamp(m_x.shareOf(x), -1.0, 2.0) * m_parts.plot.width();
  }
  double yOf(double y) const {
    return m_parts.plot.bottom() - std::clamp(m_y.shareOf(y), -1.0, 2.0) * m_parts.plot.height();
  }

  void drawZones() {
    const double worst = m_colours.zone.alphaF();
    for (std::size_t k = 0; k < m_figure.zones.size(); ++k) {
      const Zone& zone = m_figure.zones[k];
      const QRectF band = bandOf(zone);
      if (band.height() <= 0.0) continue;
      QColor colour = m_colours.zone;
      const auto share = static_cast<double>(k + 1) / static_cast<double>(m_figure.zones.size());
      colour.setAlphaF(static_cast<float>(worst * share));
      m_painter.fillRect(band, colour);
      m_painter.setPen(QPen(m_colours.ink, 1, Qt::DotLine));
      if (band.top() > m_parts.plot.top()) m_painter.drawLine(band.topLeft(), band.topRight());
    }
  }

  /// Over the lines, on paper of their own.
  void drawZoneNames() {
    for (const Zone& zone : m_figure.zones) {
      const QRectF band = bandOf(zone);
      const QFontMetricsF metrics(m_painter.font());
      const double width = metrics.horizontalAdvance(words(zone.name)) + gap;
      if (zone.name.empty() || band.height() < metrics.height() + 4) continue;
      const QRectF label(band.right() - width - 2, band.top() + 2, width, metrics.height());
      m_painter.fillRect(label, m_colours.paper);
      m_painter.setPen(m_colours.ink);
      m_painter.drawText(label, Qt::AlignCenter, words(zone.name));
    }
  }

  QRectF bandOf(const Zone& zone) const {
    return QRectF(QPointF(m_parts.plot.left(), yOf(zone.high)),
                  QPointF(m_parts.plot.right(), yOf(zone.low)))
        .intersected(m_parts.plot);
  }

  void drawGaps() {
    for (const Zone& none : m_figure.gaps) {
      const QRectF band =
          QRectF(QPointF(xOf(none.low), m_parts.plot.top()),
                 QPointF(std::max(xOf(none.high), xOf(none.low) + 1), m_parts.plot.bottom()))
              .intersected(m_parts.plot);
      if (band.width() <= 0.0) continue;
      m_painter.fillRect(band, m_colours.gap);
      drawGapName(band, words(none.name));
    }
  }

  /// On paper of its own, so that it can be read on the hatching; upright where it is narrow.
  void drawGapName(const QRectF& band, const QString& name) {
    const QFontMetricsF metrics(m_painter.font());
    const QSizeF size(metrics.horizontalAdvance(name) + gap, metrics.height());
    if (name.isEmpty()) return;
    const bool lying = band.width() >= size.width();
    if (!lying && (band.width() < size.height() || band.height() < size.width())) return;
    m_painter.save();
    m_painter.translate(band.center());
    if (!lying) m_painter.rotate(-90);
    const QRectF label(-size.width() / 2, -size.height() / 2, size.width(), size.height());
    m_painter.fillRect(label, m_colours.paper);
    m_painter.setPen(m_colours.ink);
    m_painter.drawText(label, Qt::AlignCenter, name);
    m_painter.restore();
  }

  void drawGrid() {
    const QRectF& plot = m_parts.plot;
    const QFontMetricsF metrics(m_painter.font());
    double free = -1e9;
    for (const auto& tick : m_x.ticks()) {
      const double x = xOf(tick.value);
      m_painter.setPen(QPen(m_colours.faint, tick.text.isEmpty() ? 0.3 : 0.8));
      m_painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
      const double half = metrics.horizontalAdvance(tick.text) / 2 + 2;
      if (tick.text.isEmpty() || x - half < free) continue;
      free = x + half;
      m_painter.setPen(m_colours.ink);
      m_painter.drawText(QRectF(x - half, plot.bottom() + 2, 2 * half, metrics.height()),
                         Qt::AlignCenter, tick.text);
    }
    double written = 1e9;
    for (const auto& tick : m_y.ticks()) {
      const double y = yOf(tick.value);
      m_painter.setPen(QPen(m_colours.faint, tick.text.isEmpty() ? 0.3 : 0.8));
      m_painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
      if (tick.text.isEmpty() || std::abs(y - written) < 0.9 * metrics.height()) continue;
      written = y;
      m_painter.setPen(m_colours.ink);
      m_painter.drawText(QRectF(m_area.left(), y - metrics.height() / 2,
                                plot.left() - m_area.left() - gap / 2, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, tick.text);
    }
  }

  void drawSeries(int index) {
    const Series& series = m_figure.series[static_cast<std::size_t>(index)];
    QPolygonF line;
    const auto flush = [&] {
      m_painter.setPen(penOf(index, m_colours.ink));
      // One sample between two gaps is no line, but must not vanish.
      if (line.size() == 1) m_painter.drawPoint(line.first());
      if (line.size() > 1) m_painter.drawPolyline(line);
      line.clear();
    };
    for (const Sample& sample : hasLine(series) ? series.samples : std::vector<Sample>{}) {
      if (!sample.y || !std::isfinite(*sample.y)) {
        flush();
        continue;
      }
      const QPointF p = place(sample.x, *sample.y);
      if (series.kind == Series::Kind::Steps && !line.isEmpty()) {
        line << QPointF(p.x(), line.last().y());
      }
      line << p;
    }
    flush();
    if (!hasMarks(series)) return;
    for (const Sample& sample : series.samples) {
      if (sample.y && std::isfinite(*sample.y)) {
        drawMark(m_painter, place(sample.x, *sample.y), index, m_colours);
      }
    }
  }

  void drawFrame() {
    m_painter.setPen(QPen(m_colours.ink, 1));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawRect(m_parts.plot);
  }

  void drawWords() {
    const double line = QFontMetricsF(m_painter.font()).height();
    m_painter.setPen(m_colours.ink);
    const QRectF& plot = m_parts.plot;
    m_painter.drawText(QRectF(plot.left(), plot.bottom() + line, plot.width(), line + gap),
                       Qt::AlignCenter, words(m_figure.x.title));
    m_painter.save();
    m_painter.translate(m_area.left() + 2, plot.center().y());
    m_painter.rotate(-90);
    m_painter.drawText(QRectF(-plot.height(), 0, 2 * plot.height(), line), Qt::AlignCenter,
                       words(m_figure.y.title));
    m_painter.restore();
    LegendRows(m_painter.font(), m_parts.legend.width(), m_figure)
        .draw(m_painter, m_parts.legend.topLeft(), m_figure, m_colours);
    if (m_figure.title.empty()) return;
    m_painter.save();
    QFont bold = m_painter.font();
    bold.setBold(true);
    m_painter.setFont(bold);
    m_painter.drawText(m_parts.title, Qt::AlignLeft | Qt::AlignVCenter, words(m_figure.title));
    m_painter.restore();
  }

  QPainter& m_painter;
  QRectF m_area;
  const Figure& m_figure;
  const ChartColours& m_colours;
  Parts m_parts;
  ChartScale m_x, m_y;
};

}  // namespace

ChartColours ChartColours::print() {
  QImage tile(8, 8, QImage::Format_RGB32);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x)
      tile.setPixelColor(x, y, (x + y) % 8 < 2 ? QColor(0x90, 0x90, 0x90) : Qt::white);
  }
  return {Qt::white, Qt::black, QColor(0xd0, 0xd0, 0xd0), QColor(0, 0, 0, 56), QBrush(tile)};
}

ChartColours ChartColours::fromTheme(const Theme& theme, const QColor& paper) {
  QColor zone = theme.text;
  zone.setAlpha(58);
  return {paper, theme.text, theme.track, zone, hatchBrush(theme)};
}

ChartRange chartRangeX(const Figure& figure) {
  return rangeOf(figure, [](const Sample& sample) { return std::optional(sample.x); });
}

ChartRange chartRangeY(const Figure& figure) {
  return rangeOf(figure, [](const Sample& sample) { return sample.y; });
}

QRectF chartPlot(const QFont& font, const QRectF& area, const Figure& figure) {
  return Parts(font, area, figure).plot;
}

void drawChart(QPainter& painter, const QRectF& area, const Figure& figure,
               const ChartColours& colours) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(area, colours.paper);
  ChartPainter(painter, area, figure, colours).draw();
  painter.restore();
}

QImage chartImage(const Figure& figure, const QSize& size) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  QFont font = painter.font();
  font.setPixelSize(15);
  painter.setFont(font);
  drawChart(painter, QRectF(image.rect()).adjusted(8, 4, -8, -4), figure, ChartColours::print());
  return image;
}

}  // namespace boomwatch
