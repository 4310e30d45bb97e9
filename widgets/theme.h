#pragma once

#include <QBrush>
#include <QColor>
#include <QPalette>

#include "pipeline/warning_level.h"

class QApplication;

namespace boomwatch {

enum class ThemeKind { Dark, Light };

/// Every colour with a meaning, once. Told apart by people who are colour-blind (after Okabe and
/// Ito), and never the only carrier of a meaning.
struct Theme {
  QColor canvas;      ///< behind pictures, maps and the cloud; dark in both themes
  QColor canvasText;  ///< on canvas
  QColor text;        ///< on panels
  QColor mutedText;   ///< on panels: hints, ticks, units
  QColor track;       ///< the empty part of a bar
  QColor outline;     ///< around marks that are drawn over pictures
  QColor bounds;      ///< limits of the environment: green
  QColor rays;        ///< search rays: green
  QColor load;        ///< load box: violet
  QColor removed;     ///< removed dynamic points: red
  QColor nearest;     ///< nearest pair: red
  QColor bar;         ///< distance bar: red
  QColor tool;        ///< the operator's tool point
  QColor clear;       ///< warning levels, as text and shapes on panels
  QColor caution;
  QColor warning;
  QColor collision;
  QColor hatchLight;  ///< never observed, no distance
  QColor hatchDark;
};

Theme themeOf(ThemeKind kind);
/// The theme that goes with a palette: dark when its window colour is.
Theme themeFor(const QPalette& palette);
QPalette paletteOf(ThemeKind kind);

/// Fusion style and palette for the whole program. GUI thread.
void applyTheme(QApplication& application, ThemeKind kind);

QColor levelColour(const Theme& theme, WarningLevel level);

/// Diagonal stripes, the sign for "not known"; the same everywhere. Not scaled with a map.
QBrush hatchBrush(const Theme& theme);

}  // namespace boomwatch
