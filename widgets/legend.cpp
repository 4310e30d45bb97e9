#include "legend.h"

#include "theme.h"

namespace boomwatch {

Legend::Legend(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void Legend::setScale(const Scale& scale) {
  if (m_sentence.isEmpty() && scale == m_scale) return;
  m_scale = scale;
  m_sentence.clear();
  setAccessibleName(tr("Colours from %1 to %2").arg(scale.first, scale.last));
  update();
}

void Legend::setSentence(const QString& sentence) {
  if (sentence == m_sentence) return;
  m_sentence = sentence;
  setAccessibleName(sentence);
  update();
}

void Legend::draw(QPainter& painter, const QRectF& area, const Scale& scale, const QColor& text) {
  const QFontMetricsF metrics(painter.font());
  constexpr double gap = 6.0;
  const double left = metrics.horizontalAdvance(scale.first) + gap;
  const double right = metrics.horizontalAdvance(scale.last) + gap;
  painter.setPen(text);
  painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter, scale.first);
  painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter, scale.last);
  const QRectF strip = area.adjusted(left, area.height() * 0.3, -right, -area.height() * 0.3);
  if (strip.width() < 8.0) return;
  const auto table = colourTable(scale.colouring);
  QImage ramp(256 - scale.darkest, 1, QImage::Format_RGB32);
  for (int k = 0; k < ramp.width(); ++k) {
    const auto& c =
        table[static_cast<std::size_t>(scale.brightFirst ? 255 - k : scale.darkest + k)];
    ramp.setPixel(k, 0, qRgb(c[0], c[1], c[2]));
  }
  painter.drawImage(strip, ramp);
}

void Legend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor text = themeFor(palette()).mutedText;
  const QRectF area = QRectF(rect()).adjusted(8, 0, -8, 0);
  if (m_sentence.isEmpty()) {
    draw(painter, area, m_scale, text);
    return;
  }
  painter.setPen(text);
  painter.drawText(area, Qt::AlignCenter, m_sentence);
}

}  // namespace boomwatch
