#pragma once

#include <QPainter>
#include <QString>
#include <QWidget>

#include "display.h"

namespace boomwatch {

/// A strip of colours with the values at its ends: "0.0 m [....] 10.0 m". GUI thread.
class Legend : public QWidget {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent = nullptr);

  struct Scale {
    MapColouring colouring = MapColouring::Uniform;
    bool brightFirst = true;   ///< the bright end on the left, as for depth
    std::uint8_t darkest = 0;  ///< index of the colour at the dark end
    QString first;
    QString last;
    bool operator==(const Scale&) const = default;
  };

  void setScale(const Scale& scale);
  /// Hidden colours, a sentence in their place ("coloured as in the picture").
  void setSentence(const QString& sentence);

  /// Draws a scale into `area`; for widgets that hold their own.
  static void draw(QPainter& painter, const QRectF& area, const Scale& scale, const QColor& text);

  QSize sizeHint() const override { return {240, 22}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Scale m_scale;
  QString m_sentence;
};

}  // namespace boomwatch
