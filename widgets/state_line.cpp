#include "state_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>

namespace boomwatch {

StateLine::StateLine(QWidget* parent)
    : QWidget(parent), m_label(new QLabel), m_close(new QToolButton), m_timer(new QTimer(this)) {
  constexpr int seconds = 6;
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 4, 2);
  row->addWidget(m_label, 1);
  row->addWidget(m_close);
  m_label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_label->setTextFormat(Qt::PlainText);
  m_close->setText(QStringLiteral("\u2715"));
  m_close->setAutoRaise(true);
  m_close->setToolTip(tr("Dismiss"));
  m_close->setAccessibleName(tr("Dismiss"));
  QSizePolicy keep = m_close->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  m_close->setSizePolicy(keep);
  m_timer->setSingleShot(true);
  m_timer->setInterval(seconds * 1000);
  connect(m_close, &QToolButton::clicked, this, &StateLine::dismiss);
  connect(m_timer, &QTimer::timeout, this, &StateLine::dismiss);
  refresh();
}

void StateLine::setState(const QString& text) {
  if (text == m_state) return;
  m_state = text;
  refresh();
}

void StateLine::showFault(const QString& text) {
  m_timer->stop();
  setNotice(QStringLiteral("\u26A0 ") + text);
}

void StateLine::showNotice(const QString& text) {
  // A notice that ends by itself must not replace a fault that the person has to dismiss.
  if (!m_notice.isEmpty() && !m_timer->isActive()) return;
  m_timer->start();
  setNotice(QStringLiteral("\u26A0 ") + text);
}

void StateLine::dismiss() {
  m_timer->stop();
  setNotice({});
}

void StateLine::setNotice(const QString& text) {
  m_notice = text;
  refresh();
}

void StateLine::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  refresh();
}

void StateLine::refresh() {
  QFont font = m_label->font();
  font.setBold(!m_notice.isEmpty());
  m_label->setFont(font);
  QString line = text();
  line.replace(QLatin1Char('\n'), QLatin1Char(' '));
  m_label->setText(m_label->fontMetrics().elidedText(line, Qt::ElideRight, m_label->width()));
  m_label->setToolTip(text());
  m_label->setAccessibleName(text());
  m_close->setVisible(!m_notice.isEmpty());
}

}  // namespace boomwatch
