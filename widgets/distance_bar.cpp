#include "distance_bar.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <map>

#include "texts.h"
#include "theme.h"

namespace boomwatch {
namespace {

/// Where everything stands: depends on the widget's size alone, never on what is shown.
struct Layout {
  QRectF level;
  QRectF number;
  QRectF hint;
  QRectF bar;
  QRectF ticks;

  explicit Layout(const QSizeF& size) {
    constexpr double margin = 10.0;
    const double width = size.width() - 2 * margin;
    const double numberHeight = std::clamp(width * 0.42, 52.0, 120.0);
    level = {0, 0, size.width(), 46};
    number = {margin, level.bottom() + 4, width, numberHeight};
    hint = {margin, number.bottom(), width, 128};
    const double top = hint.bottom() + 12;
    const double height = std::max(20.0, size.height() - top - 14);
    bar = {margin, top, width * 0.55, height};
    ticks = {bar.right() + 2, top, size.width() - bar.right() - 4, height};
  }
};

QColor readableOn(const QColor& colour) {
  return colour.lightnessF() > 0.42F ? QColor(0x14171a) : QColor(Qt::white);
}

QPolygonF regularPolygon(const QRectF& area, int corners, double turn) {
  QPolygonF polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = turn + 2 * M_PI * k / corners;
    polygon << area.center() + QPointF(std::cos(angle), std::sin(angle)) * (area.width() / 2);
  }
  return polygon;
}

/// A shape a level, so that its colour is not needed: ring and tick, hollow triangle, solid
/// triangle, solid octagon with a cross, dashed ring with a question mark.
void drawShape(QPainter& painter, const QRectF& area, WarningLevel level, const QColor& ink,
               const QColor& ground) {
  painter.setPen(QPen(ink, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  const QPointF c = area.center();
  const double r = area.width() / 2;
  const bool solid = level == WarningLevel::Warning || level == WarningLevel::Collision;
  if (solid) painter.setBrush(ink);
  switch (level) {
    case WarningLevel::Clear:
      painter.drawEllipse(area);
      painter.drawPolyline(QPolygonF{c + QPointF(-r * .45, 0), c + QPointF(-r * .1, r * .4),
                                     c + QPointF(r * .5, -r * .4)});
      return;
    case WarningLevel::Caution:
    case WarningLevel::Warning: {
      painter.drawPolygon(regularPolygon(area, 3, -M_PI / 2));
      painter.setPen(QPen(solid ? ground : ink, 2.5, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(c + QPointF(0, -r * .4), c + QPointF(0, r * .05));
      painter.drawPoint(c + QPointF(0, r * .32));
      return;
    }
    case WarningLevel::Collision:
      painter.drawPolygon(regularPolygon(area, 8, M_PI / 8));
      painter.setPen(QPen(ground, 3, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(c + QPointF(-r * .4, -r * .4), c + QPointF(r * .4, r * .4));
      painter.drawLine(c + QPointF(-r * .4, r * .4), c + QPointF(r * .4, -r * .4));
      return;
    case WarningLevel::NoDistance:
      painter.setPen(QPen(ink, 2, Qt::DashLine));
      painter.drawEllipse(area);
      painter.setPen(ink);
      painter.drawText(area, Qt::AlignCenter, QStringLiteral("?"));
      return;
  }
}

void drawLevel(QPainter& painter, const QRectF& area, WarningLevel level, const Theme& theme) {
  const bool alarm = level != WarningLevel::Clear && level != WarningLevel::NoDistance;
  const QColor ground = alarm ? levelColour(theme, level) : theme.track;
  const QColor ink = alarm ? readableOn(ground) : theme.text;
  painter.fillRect(area, ground);
  QFont font = painter.font();
  font.setPixelSize(20);
  font.setBold(true);
  painter.setFont(font);
  drawShape(painter, QRectF(area.left() + 12, area.center().y() - 13, 26, 26), level, ink, ground);
  painter.setPen(ink);
  const QRectF words = area.adjusted(46, 0, -4, 0);
  const QString text = levelText(level);
  const double needed = QFontMetricsF(font).horizontalAdvance(text);
  if (needed > words.width()) font.setPixelSize(static_cast<int>(20 * words.width() / needed));
  painter.setFont(font);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, text);
}

/// Right-aligned, so that digits (all of one width) stay where they are as the number changes.
void drawNumber(QPainter& painter, const QRectF& area, const QString& text, const Theme& theme) {
  QFont font = painter.font();
  font.setBold(true);
  font.setPixelSize(static_cast<int>(area.height()));
  const QString widest = text.size() > 4 ? text : QStringLiteral("00.0");
  const double unit = area.width() * 0.16;
  const double needed = QFontMetricsF(font).horizontalAdvance(widest);
  const double allowed = area.width() - unit;
  if (needed > allowed) font.setPixelSize(static_cast<int>(area.height() * allowed / needed));
  painter.setFont(font);
  painter.setPen(theme.text);
  painter.drawText(area.adjusted(0, 0, -unit, 0), Qt::AlignRight | Qt::AlignVCenter, text);
  if (!text.back().isDigit()) return;
  font.setPixelSize(20);
  font.setBold(false);
  painter.setFont(font);
  painter.setPen(theme.mutedText);
  painter.drawText(area.adjusted(0, 0, 0, -area.height() * 0.16), Qt::AlignRight | Qt::AlignBottom,
                   DistanceBar::tr("m"));
}

/// Smaller where a language needs more room: a reason must never be cut short.
void drawHint(QPainter& painter, const QRectF& area, const QString& text, const Theme& theme) {
  constexpr int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
  QFont font = painter.font();
  font.setBold(false);
  for (int pixels = 13; pixels >= 9; --pixels) {
    font.setPixelSize(pixels);
    if (area.contains(QFontMetricsF(font).boundingRect(area, flags, text))) break;
  }
  painter.setFont(font);
  painter.setPen(theme.mutedText);
  painter.drawText(area, flags, text);
}

/// The finest of 1, 2, 5 x 10^n that divides `span` into at most five.
double tickStep(double span) {
  const double decade = std::pow(10.0, std::floor(std::log10(span / 5)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (span / (step * decade) <= 5.0 + 1e-9) return step * decade;
  }
  return 10 * decade;
}

void drawTicks(QPainter& painter, const Layout& layout, const WarningParameters& warning,
               const Theme& theme) {
  const double span = warning.cautionDistance;
  auto yOf = [&](double metres) {
    return layout.bar.top() + layout.bar.height() * std::min(1.0, metres / span);
  };
  QFont font = painter.font();
  font.setPixelSize(13);
  painter.setFont(font);
  const double step = tickStep(span);
  for (int k = 0; k * step <= span * (1 + 1e-9); ++k) {
    const double y = yOf(k * step);
    painter.setPen(theme.mutedText);
    painter.drawLine(QPointF(layout.ticks.left(), y), QPointF(layout.ticks.left() + 6, y));
    painter.drawText(QRectF(layout.ticks.left() + 10, y - 9, layout.ticks.width(), 18),
                     Qt::AlignLeft | Qt::AlignVCenter, QLocale().toString(k * step, 'g', 3));
  }
  // Where the warning begins.
  painter.setPen(QPen(theme.text, 2, Qt::DotLine));
  const double y = yOf(warning.warningDistance);
  painter.drawLine(QPointF(layout.bar.left(), y), QPointF(layout.ticks.left() + 6, y));
}

}  // namespace

DistanceBar::DistanceBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  announce();
}

void DistanceBar::setDisplay(const DisplayPtr& display) {
  m_display = display && display->result ? display : nullptr;
  m_latched.reset();
  announce();
  update();
}

void DistanceBar::setLatchedLevel(WarningLevel level) {
  m_latched = level;
  announce();
  update();
}

const Nearest* DistanceBar::nearest() const {
  if (!m_display) return nullptr;
  const Clearance& clearance = m_display->result->clearance;
  const bool measured = clearance.state == ClearanceState::Measured && clearance.nearest;
  return measured ? &*clearance.nearest : nullptr;
}

bool DistanceBar::nothingInRange() const {
  return m_display && m_display->result->clearance.state == ClearanceState::NothingInRange;
}

double DistanceBar::searchedRange() const { return searchReach(m_display->result->parameters); }

QString DistanceBar::nothingWithin() const {
  return tr("no obstacle within %1 m").arg(QLocale().toString(searchedRange(), 'g', 3));
}

std::optional<double> DistanceBar::fill() const {
  if (nothingInRange()) return 0.0;
  const Nearest* found = nearest();
  if (!found) return std::nullopt;
  const double span = m_display->result->parameters.warning.cautionDistance;
  return std::clamp(1.0 - found->distance / span, 0.0, 1.0);
}

QString DistanceBar::numberText() const {
  if (nothingInRange()) return QStringLiteral("> ") + QLocale().toString(searchedRange(), 'g', 3);
  const Nearest* found = nearest();
  if (!found) return QStringLiteral("\u2013");
  const double d = found->distance;
  // A fixed number of digits keeps the width. Rounded down: never more than the distance.
  const int digits = d < 10.0 ? 2 : d < 100.0 ? 1 : 0;
  const double unit = std::pow(10.0, -digits);
  return QLocale().toString(std::floor(d / unit + 1e-6) * unit, 'f', digits);
}

WarningLevel DistanceBar::level() const {
  if (m_latched) return *m_latched;
  return m_display ? m_display->result->level : WarningLevel::NoDistance;
}

QString DistanceBar::leadText(const Result& result, const Nearest& nearest) {
  if (nearest.unseen) return tr("to unobserved space");
  const Watched* leading =
      result.leading < result.watched.size() ? &result.watched[result.leading] : nullptr;
  const bool isLoad = !leading || leading->object == WatchedObject::Load;
  return isLoad ? tr("to %1").arg(partText(nearest.part))
                : tr("from the %1").arg(watchedText(*leading));
}

QString DistanceBar::hintText() const {
  const Nearest* found = nearest();
  if (!found && !nothingInRange()) {
    const Reason reason = m_display ? m_display->result->clearance.reason : Reason::NoFrame;
    const QString text = reasonTitle(reason) + QStringLiteral(".\n") + reasonText(reason);
    return reason == Reason::SearchTooShort ? text + QLatin1Char('\n') + nothingWithin() : text;
  }
  const Result& result = *m_display->result;
  QStringList lines;
  if (found) {
    const double error = found->quantisation + result.depthUncertainty.value_or(0.0);
    lines << leadText(result, *found);
    lines << QStringLiteral("\u00b1 ") + metresText(error);
    if (const auto& evidence = result.clearance.evidence) {
      lines << tr("evidence %1 %").arg(std::floor(evidence->confidence * 100.0));
    }
  } else {
    lines << nothingWithin();
  }
  if (result.approach && result.approach->timeToContact) {
    const double seconds = std::floor(*result.approach->timeToContact * 10.0) / 10.0;
    lines << tr("contact in %1 s").arg(QLocale().toString(seconds, 'f', 1));
  }
  const bool ignored = result.parameters.clearance.unknownSpace == UnknownSpace::Ignore;
  if (const auto share = result.clearance.observedShare; share && !ignored) {
    // Rounded down: 100 % only when every cell was observed.
    const int percent = static_cast<int>(std::floor(*share * 100.0 + 1e-9));
    lines << (percent >= 100
                  ? tr("observed all around it")
                  : tr("%1 % around it unobserved: an obstacle may be nearer").arg(100 - percent));
  }
  lines << othersText(result);
  lines.removeAll({});
  return lines.join(QLatin1Char('\n'));
}

/// The other watched parts in one line; of the boom only its nearest segment.
QString DistanceBar::othersText(const Result& result) {
  const auto distanceOf = [](const Watched& watched) {
    return watched.clearance.nearest ? watched.clearance.nearest->distance : HUGE_VAL;
  };
  std::map<WatchedObject, const Watched*> nearest;
  for (const Watched& watched : result.watched) {
    const Watched*& best = nearest[watched.object];
    if (!best || distanceOf(watched) < distanceOf(*best)) best = &watched;
  }
  if (result.leading < result.watched.size()) nearest.erase(result.watched[result.leading].object);
  QStringList parts;
  for (const auto& [object, watched] : nearest) parts << watchedDistance(*watched);
  return parts.join(QStringLiteral(", "));
}

QString DistanceBar::detailText() const {
  QStringList lines{hintText()};
  if (m_display && m_display->result->watched.size() > 1) {
    for (const Watched& watched : m_display->result->watched) lines << watchedDistance(watched);
  }
  return lines.join(QLatin1Char('\n'));
}

void DistanceBar::announce() {
  const QString distance = nearest() ? tr("%1 m").arg(numberText()) : hintText();
  const QString name = tr("Distance: %1, %2").arg(levelText(level()), distance);
  if (name != accessibleName()) setAccessibleName(name);
  setToolTip(detailText());
}

void DistanceBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme theme = themeFor(palette());
  const Layout layout((QSizeF(size())));
  drawLevel(painter, layout.level, level(), theme);
  drawNumber(painter, layout.number, numberText(), theme);
  drawHint(painter, layout.hint, hintText(), theme);
  QPainterPath shape;
  shape.addRoundedRect(layout.bar, 4, 4);
  const auto share = fill();
  painter.fillPath(shape, share ? QBrush(theme.track) : hatchBrush(theme));
  if (share && *share > 0.0) {
    painter.save();
    painter.setClipPath(shape);
    painter.fillRect(layout.bar.adjusted(0, layout.bar.height() * (1.0 - *share), 0, 0), theme.bar);
    painter.restore();
  }
  drawTicks(painter, layout,
            m_display ? m_display->result->parameters.warning : WarningParameters{}, theme);
}

}  // namespace boomwatch
