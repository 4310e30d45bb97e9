#include "theme.h"

#include <QApplication>
#include <QImage>
#include <QStyleFactory>

namespace boomwatch {
namespace {

QPalette makePalette(const QColor& window, const QColor& base, const QColor& button,
                     const QColor& text, const QColor& accent) {
  QPalette palette(button, window);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, accent);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                          QPalette::ToolTipText, QPalette::BrightText}) {
    palette.setColor(role, text);
  }
  QColor faint = text;
  faint.setAlpha(110);
  palette.setColor(QPalette::PlaceholderText, faint);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, faint);
  }
  return palette;
}

}  // namespace

Theme themeOf(ThemeKind kind) {
  const bool dark = kind == ThemeKind::Dark;
  Theme theme;
  theme.canvas = QColor(0x16191d);
  theme.canvasText = QColor(0xdfe3e8);
  theme.text = dark ? QColor(0xe6e9ed) : QColor(0x1d2126);
  theme.mutedText = dark ? QColor(0x9aa4b0) : QColor(0x59636f);
  theme.track = dark ? QColor(0x30363d) : QColor(0xd9dde2);
  theme.outline = QColor(0x0b0d0f);
  theme.bounds = QColor(0x1fbf8f);
  theme.rays = QColor(0x35d39f);
  theme.load = QColor(0xb48cff);
  theme.removed = QColor(0xff6b5e);
  theme.nearest = QColor(0xff4136);
  theme.tool = QColor(0x56c2ff);
  theme.clear = dark ? QColor(0x8fb8d8) : QColor(0x2b6a99);
  theme.caution = dark ? QColor(0xf0c340) : QColor(0x8a6500);
  theme.warning = dark ? QColor(0xff9a3c) : QColor(0xb04a00);
  theme.collision = dark ? QColor(0xff5548) : QColor(0xc21f14);
  theme.bar = QColor(0xe0362b);
  theme.hatchLight = QColor(0x53606f);
  theme.hatchDark = QColor(0x22282f);
  return theme;
}

Theme themeFor(const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightness() < 128;
  return themeOf(dark ? ThemeKind::Dark : ThemeKind::Light);
}

QPalette paletteOf(ThemeKind kind) {
  if (kind == ThemeKind::Dark) {
    return makePalette(QColor(0x23272d), QColor(0x1b1e23), QColor(0x30353d), QColor(0xe6e9ed),
                       QColor(0x2f7fb8));
  }
  return makePalette(QColor(0xf1f3f5), QColor(0xffffff), QColor(0xe4e7eb), QColor(0x1d2126),
                     QColor(0x2b6a99));
}

void applyTheme(QApplication& application, ThemeKind kind) {
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  application.setPalette(paletteOf(kind));
}

QColor levelColour(const Theme& theme, WarningLevel level) {
  switch (level) {
    case WarningLevel::Clear:
      return theme.clear;
    case WarningLevel::Caution:
      return theme.caution;
    case WarningLevel::Warning:
      return theme.warning;
    case WarningLevel::Collision:
      return theme.collision;
    case WarningLevel::NoDistance:
      return theme.mutedText;
  }
  return theme.text;
}

QBrush hatchBrush(const Theme& theme) {
  constexpr int period = 8;
  QImage tile(period, period, QImage::Format_RGB32);
  for (int y = 0; y < period; ++y) {
    for (int x = 0; x < period; ++x) {
      const bool stripe = (x + y) % period < 3;
      tile.setPixelColor(x, y, stripe ? theme.hatchLight : theme.hatchDark);
    }
  }
  return QBrush(tile);
}

}  // namespace boomwatch
