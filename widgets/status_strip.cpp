#include "status_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>

#include "texts.h"

namespace boomwatch {
namespace {

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

QString millisecondsText(double value) { return number(value, value < 9.95 ? 1 : 0); }

QLabel* fixedField(const QString& widest) {
  auto* label = new QLabel;
  label->setFixedWidth(label->fontMetrics().horizontalAdvance(widest) + 12);
  return label;
}

QString validityOf(const Result& result) {
  const Clearance& clearance = result.clearance;
  if (clearance.state != ClearanceState::Unknown) return StatusStrip::tr("\u2713 valid");
  return StatusStrip::tr("\u2715 no distance: %1").arg(reasonTitle(clearance.reason));
}

/// Reason, load fault, age of the load and share of masked points, one a line.
QString validityDetail(const Result& result) {
  QStringList lines{reasonText(result.clearance.reason), loadFaultText(result.loadFault)};
  if (result.load && result.loadAge && *result.loadAge > 0.0) {
    lines += StatusStrip::tr("Load last detected %1 s ago.").arg(number(*result.loadAge, 1));
  }
  if (!result.scene.removed.empty()) {
    lines += StatusStrip::tr("%1 % of the points are masked as boom, tool and load.")
                 .arg(number(100.0 * result.removedShare, 1));
  }
  lines.removeAll({});
  return lines.join(u'\n');
}

}  // namespace

StatusStrip::StatusStrip(QWidget* parent) : QStatusBar(parent) {
  setSizeGripEnabled(false);
  setMinimumWidth(1);  // the window may be narrower than all fields together
  m_rate = addField(tr("%1 fps").arg(number(9999.9, 1)));
  m_latency = addField(tr("latency %1 ms").arg(number(99999, 0)));
  m_dropped = addField(tr("skipped %1, dropped %2").arg(99999).arg(99999));
  m_dropped->setToolTip(
      tr("Skipped frames were processed but replaced before the window showed them. Dropped frames "
         "came from a live source and were not read."));
  m_stageFields = new QWidget;
  m_stageRow = new QHBoxLayout(m_stageFields);
  m_stageRow->setContentsMargins(0, 0, 0, 0);
  addWidget(m_stageFields);
  m_validity = new QLabel;
  addPermanentWidget(m_validity);
  setRate(0.0);
  m_latency->setText(tr("latency %1 ms").arg(QStringLiteral("\u2013")));
  setDropped(0, 0);
}

QLabel* StatusStrip::addField(const QString& widest) {
  QLabel* label = fixedField(widest);
  addWidget(label);
  return label;
}

QLabel* StatusStrip::stageField(std::string_view stage) {
  if (const auto found = m_stages.find(stage); found != m_stages.end()) return found->second;
  QLabel* label = fixedField(tr("%1 %2").arg(stageText(stage), number(99999, 0)));
  label->setToolTip(tr("Time of this stage for the last frame, in milliseconds"));
  m_stageRow->addWidget(label);
  m_stagesWidth += label->width() + m_stageRow->spacing();
  fitStages();
  return m_stages.emplace(std::string(stage), label).first->second;
}

/// Depends on the width of the window only, so that the fields do not come and go with the values.
void StatusStrip::fitStages() {
  const int validity = fontMetrics().averageCharWidth() * 36;
  const int others = m_rate->width() + m_latency->width() + m_dropped->width() + validity;
  m_stageFields->setVisible(others + m_stagesWidth <= width());
}

void StatusStrip::resizeEvent(QResizeEvent* event) {
  QStatusBar::resizeEvent(event);
  fitStages();
}

void StatusStrip::showResult(const Result& result) {
  for (const auto& [name, label] : m_stages) {
    label->setText(tr("%1 %2").arg(stageText(name), QStringLiteral("\u2013")));
  }
  for (const StageTiming& timing : result.timings) {
    stageField(timing.stage)
        ->setText(tr("%1 %2").arg(stageText(timing.stage), millisecondsText(timing.milliseconds)));
  }
  m_validity->setText(validityOf(result));
  m_validity->setToolTip(validityDetail(result));
}

void StatusStrip::setRate(double framesPerSecond) {
  const QString text =
      framesPerSecond > 0.0 ? number(framesPerSecond, 1) : QStringLiteral("\u2013");
  m_rate->setText(tr("%1 fps").arg(text));
}

void StatusStrip::setLatency(double milliseconds) {
  m_latency->setText(tr("latency %1 ms").arg(number(milliseconds, 0)));
}

void StatusStrip::setDropped(std::size_t skipped, std::size_t lost) {
  m_dropped->setText(tr("skipped %1, dropped %2").arg(skipped).arg(lost));
}

QString StatusStrip::validityText() const { return m_validity->text(); }

}  // namespace boomwatch
