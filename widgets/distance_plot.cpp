#include "distance_plot.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "chart.h"
#include "texts.h"
#include "theme.h"

namespace boomwatch {
namespace {

using Moment = DistanceHistory::Moment;

/// The zones and half as much above them; doubled until everything is in it, so that the scale
/// seldom changes.
double maxShown(const std::deque<Moment>& moments, double caution) {
  double highest = 0.0;
  for (const Moment& moment : moments) {
    highest = std::max({highest, moment.distance.value_or(0.0), moment.truth.value_or(0.0)});
  }
  double shown = 1.5 * caution;
  while (shown < highest) shown *= 2.0;
  return shown;
}

/// Stretches without a distance, one for each reason in a row; up to the next frame.
std::vector<Zone> gapsIn(const std::deque<Moment>& moments, double now) {
  std::vector<Zone> gaps;
  Reason last = Reason::None;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const Reason reason = moments[k].reason;
    const bool goesOn = reason == last && !gaps.empty();
    last = reason;
    if (reason == Reason::None) continue;
    const double begin = moments[k].stamp - now;
    const double end = k + 1 < moments.size() ? moments[k + 1].stamp - now : 0.0;
    if (goesOn) {
      gaps.back().high = end;
    } else {
      gaps.push_back({begin, end, reasonTitle(reason).toStdString()});
    }
  }
  return gaps;
}

}  // namespace

DistancePlot::DistancePlot(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void DistancePlot::setDisplay(const DisplayPtr& display) {
  if (!display || !display->result) return;
  const Result& result = *display->result;
  const double since = m_sinceFrame.isValid() ? m_sinceFrame.elapsed() / 1000.0 : 0.0;
  m_history.add(result, since);
  if (result.frame) m_sinceFrame.start();
  m_warning = result.parameters.warning;
  update();
}

void DistancePlot::clear() {
  m_history.clear();
  m_sinceFrame.invalidate();
  update();
}

Figure DistancePlot::figure() const {
  const auto words = [](const QString& text) { return text.toStdString(); };
  const auto& moments = m_history.moments();
  const double now = m_history.now();
  Figure figure;
  figure.x = {words(tr("time (s), 0 is now")), false, -DistanceHistory::span, 0.0};
  figure.y = {words(tr("distance (m)")), false, 0.0, maxShown(moments, m_warning.cautionDistance)};
  figure.zones = {{m_warning.warningDistance, m_warning.cautionDistance, words(tr("caution"))},
                  {0.0, m_warning.warningDistance, words(tr("warning"))}};
  figure.gaps = gapsIn(moments, now);
  Series reported{words(tr("reported")), {}}, truth{words(tr("truth")), {}};
  for (const Moment& moment : moments) {
    reported.samples.push_back({moment.stamp - now, moment.distance});
    truth.samples.push_back({moment.stamp - now, moment.truth});
  }
  const bool known =
      std::ranges::any_of(moments, [](const Moment& moment) { return moment.truth.has_value(); });
  figure.series.push_back(std::move(reported));
  if (known) figure.series.push_back(std::move(truth));
  return figure;
}

QRectF DistancePlot::area() const { return QRectF(rect()).adjusted(4, 2, -6, -2); }

QString DistancePlot::textAt(const QPoint& place) const {
  const auto& moments = m_history.moments();
  const QRectF plot = chartPlot(font(), area(), figure());
  if (moments.empty() || !plot.contains(place)) return {};
  const double share = (place.x() - plot.left()) / plot.width();
  const double stamp = m_history.now() - DistanceHistory::span * (1.0 - share);
  if (stamp < moments.front().stamp) return {};
  const auto next = std::ranges::upper_bound(moments, stamp, {}, &Moment::stamp);
  const Moment& moment = *(next - 1);
  QStringList lines{tr("%1 s ago").arg(QLocale().toString(m_history.now() - moment.stamp, 'f', 1))};
  if (moment.reason != Reason::None) {
    lines << reasonTitle(moment.reason) + QStringLiteral(". ") + reasonText(moment.reason);
  } else {
    lines << (moment.distance ? tr("reported: %1").arg(metresText(*moment.distance))
                              : tr("no obstacle in range"));
  }
  if (moment.truth) lines << tr("truth: %1").arg(metresText(*moment.truth));
  return lines.join(QLatin1Char('\n'));
}

bool DistancePlot::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), textAt(help->pos()), this);
  return true;
}

void DistancePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor paper = palette().color(QPalette::Base);
  painter.fillRect(rect(), paper);
  drawChart(painter, area(), figure(), ChartColours::fromTheme(themeFor(palette()), paper));
}

}  // namespace boomwatch
